#!/usr/bin/env bash
# Where things are: the one environment that every command of this project runs in. It looks and never
# installs; what is missing, scripts/setup.sh gets.
#
#   scripts/env.sh COMMAND…           run a command in it
#   scripts/env.sh --wasm COMMAND…    the same, with a Rust that can compile to wasm32
#   source scripts/env.sh             take it over into a script
#
# A browser of your own choice: set CHROME, or FIREFOX. What drives pages by the hundred takes HEADLESS_SHELL, Chromium without
# windows; unless that is there, or where you chose CHROME, it takes CHROME.

RIVERSEED_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export RIVERSEED_ROOT
export RIVERSEED_CACHE=${XDG_CACHE_HOME:-$HOME/.cache}/riverseed

# shellcheck source=scripts/lib/versions.sh
source "$RIVERSEED_ROOT/scripts/lib/versions.sh"
# shellcheck source=scripts/lib/rust.sh
source "$RIVERSEED_ROOT/scripts/lib/rust.sh"

# Our tools come first, since their versions are pinned; rustup's folder comes last, for shells that have not read
# their profile.
our_tools=$RIVERSEED_CACHE/tools/bin:$RIVERSEED_ROOT/www/node_modules/.bin
rustup_folder=${CARGO_HOME:-$HOME/.cargo}/bin
PATH=$our_tools:$PATH:$rustup_folder
export PATH
prefer_newer_rust

# The path of the first of some commands that exists; nothing if none does.
first_of() {
  local name
  for name; do command -v "$name" && return; done
  return 0
}

own_shell=${HEADLESS_SHELL-} own_chrome=${CHROME-} own_firefox=${FIREFOX-}
find_browsers() {
  export CHROME=${own_chrome:-$(first_of chromium chromium-browser google-chrome-stable google-chrome)}
  HEADLESS_SHELL=${own_shell:-${own_chrome:-$(first_of chromium-headless-shell)}}
  export HEADLESS_SHELL=${HEADLESS_SHELL:-$CHROME}
  export FIREFOX=${own_firefox:-$(first_of firefox-esr firefox)}
}
find_browsers

# With any of these set, cargo would leave out flags of .cargo/config.toml, or add to them: another module than everybody's.
drop_rustflags() {
  local name
  for name in RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS; do
    [[ -n ${!name-} ]] || continue
    echo "$name is left out here: .cargo/config.toml has the flags of wasm32" >&2
    unset "$name"
  done
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  if [[ ${1-} == --wasm ]]; then
    shift
    use_wasm_rust || { echo "No Rust here compiles to wasm32 yet: run scripts/setup.sh wasm" >&2; exit 1; }
    drop_rustflags
    # A folder of its own: a library that is both rlib and cdylib has one file name for all its builds, so those of two
    # compilers, or of two sets of features, would take each other's place.
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$RIVERSEED_ROOT/target}/wasm
  fi
  exec "$@"
fi
