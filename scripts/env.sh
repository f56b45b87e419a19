#!/usr/bin/env bash
# Where things are: the one environment that every command of this project runs in. It looks and never
# installs; what is missing, scripts/setup.sh gets.
#
#   scripts/env.sh COMMAND…           run a command in it
#   scripts/env.sh --wasm COMMAND…    the same, with a Rust that can compile to wasm32
#   source scripts/env.sh             take it over into a script
#
# A browser of your own choice: set CHROME and CHROMEDRIVER (of one version), or FIREFOX.

RIVERSEED_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export RIVERSEED_ROOT
export RIVERSEED_CACHE=${XDG_CACHE_HOME:-$HOME/.cache}/riverseed

# Our tools come first, since their versions are pinned; rustup's folder comes last, for shells that have not read
# their profile.
PATH=$RIVERSEED_CACHE/tools/bin:$RIVERSEED_ROOT/www/node_modules/.bin:$PATH:${CARGO_HOME:-$HOME/.cargo}/bin
export PATH

# The path of the first of some commands that exists; nothing if none does.
first_of() {
  local name
  for name; do command -v "$name" && return; done
  return 0
}

export CHROME=${CHROME:-$(first_of chromium chromium-browser google-chrome-stable google-chrome)}
export CHROMEDRIVER=${CHROMEDRIVER:-$(first_of chromedriver)}
export FIREFOX=${FIREFOX:-$(first_of firefox-esr firefox)}

# Wasm tests are programs that a browser runs.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER=wasm-bindgen-test-runner
export WASM_BINDGEN_TEST_TIMEOUT=${WASM_BINDGEN_TEST_TIMEOUT:-600} # seconds for a test file; by itself it allows 20
export WASM_BINDGEN_TEST_WEBDRIVER_JSON=$RIVERSEED_ROOT/target/webdriver.json

# Whether the Rust on PATH has the standard library for wasm32.
has_wasm_target() {
  local lib
  lib=$(rustc --print target-libdir --target wasm32-unknown-unknown 2>/dev/null) && [[ -d $lib ]]
}

# The folder of our own toolchain, made from Debian's Rust. It carries the package's version, because an update of the
# package makes the compiled standard library useless.
debian_rust() {
  local version
  version=$(dpkg-query --show --showformat='${Version}' rustc-web 2>/dev/null) || return 1
  echo "$RIVERSEED_CACHE/rust-${version//[^0-9A-Za-z.]/-}"
}

# Puts a Rust with wasm32 first on PATH. By PATH and not by RUSTUP_TOOLCHAIN, so that rustup's settings stay as they
# are and a machine without rustup works too.
use_wasm_rust() {
  has_wasm_target && return
  local dir
  dir=$(debian_rust) && [[ -d $dir ]] && PATH=$dir/bin:$PATH
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  if [[ ${1-} == --wasm ]]; then
    shift
    use_wasm_rust || { echo "No Rust here compiles to wasm32 yet: run scripts/setup.sh wasm" >&2; exit 1; }
    # A folder of its own: a library that is both rlib and cdylib has one file name for all its builds, so those of two
    # compilers, or of two sets of features, would take each other's place.
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$RIVERSEED_ROOT/target}/wasm
  fi
  exec "$@"
fi
