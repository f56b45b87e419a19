# A machine made of stand-ins: what the scripts find on it, and what they ask of it, without touching the real one.
#
#   $machine/usr/bin        what its system has: $PATH is this, a few real tools, and what a test puts before them
#   $machine/lists/NAME     the version of a package that apt knows of; $machine/archive/NAME what there is by now
#   $machine/installed/NAME the version that is installed
#   $machine/calls          every call of a stand-in that changes something, a line each
#   $checkout               this project's scripts, and what they read
#
# Each file of stand-ins/ says what it imitates.
# shellcheck shell=bash disable=SC2154  # bats sets $status and $output

project=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
stand_ins=$project/tests/scripts/stand-ins
real_node=$(command -v node)

# A Debian with apt, a linker, Node and nothing else.
new_machine() {
  machine=$BATS_TEST_TMPDIR/machine
  checkout=$BATS_TEST_TMPDIR/checkout
  usr=$machine/usr
  toolchain=$machine/rustup/toolchain
  export machine usr toolchain real stand_ins real_node
  mkdir -p "$usr"/{bin,lib/rustlib} "$machine"/{lists,archive,installed,home,cache}
  real_tools
  cp "$stand_ins"/{apt-get,apt-cache,dpkg-query,sudo,sleep,cc} "$usr/bin"
  touch "$machine/calls"
  touch "$usr/lib/crt1.o"
  put_node 20.20.2
  new_checkout
}

# Once a file.
real_tools() {
  local tools
  real=$BATS_FILE_TMPDIR/real
  [[ ! -d $real ]] || return 0
  mkdir "$real"
  read -r -d "" -a tools < <(type -P awk basename bash sh env cat cmp cp cut cksum chmod diff dirname find flock grep gzip \
    head ln ls make mkdir mktemp mv od readlink rm rmdir sed shuf sleep sort tail tar sha256sum touch wc xargs) || true
  ln -s "${tools[@]}" "$real"
}

new_checkout() {
  mkdir -p "$checkout/www/scripts" "$checkout/src" "$checkout/crates/wasm/src"
  cp -R "$project"/{scripts,.cargo,Cargo.toml,wasm-pack.toml,Makefile} "$checkout"
  cp "$project/crates/wasm/Cargo.toml" "$checkout/crates/wasm"
  echo 'pub fn map() {}' >"$checkout/crates/wasm/src/lib.rs"
  cp "$project/www/scripts/weigh-widget.mjs" "$checkout/www/scripts"
  printf '[[package]]\nname = "wasm-bindgen"\nversion = "0.2.130"\n' >"$checkout/Cargo.lock"
  echo 'pub fn river() {}' >"$checkout/src/lib.rs"
  local toml
  toml=$(sed -n 's/.*"version": "\(.*\)",*/\1/p' "$project/www/node_modules/smol-toml/package.json" | head -n 1)
  echo "{ \"packages\": { \"node_modules/smol-toml\": { \"version\": \"$toml\" } } }" >"$checkout/www/package-lock.json"
  echo '{}' >"$checkout/www/package.json"
}

# ---- what a machine has

# put NAME [FOLDER]: a stand-in as a command.
put() {
  mkdir -p "${2:-$usr/bin}"
  cp "$stand_ins/$1" "${2:-$usr/bin}/$1"
}

# program NAME VERSION [FOLDER]: a command that only says its version.
program() {
  mkdir -p "${3:-$usr/bin}"
  printf '#!/bin/sh\necho "%s %s"\n' "$1" "$2" >"${3:-$usr/bin}/$1"
  chmod +x "${3:-$usr/bin}/$1"
}

put_node() {
  put node
  put npm
  echo "$1" >"$machine/node-version"
}

# put_rust VERSION SYSROOT: a compiler, with its standard library for this machine alone.
put_rust() {
  put rustc "$2/bin"
  put cargo "$2/bin"
  cp "$stand_ins/rustc" "$2/bin/rustdoc"
  echo "$1" >"$2/rust-version"
  mkdir -p "$2/lib/rustlib/x86_64-unknown-linux-gnu/"{lib,bin} "$2/lib/rustlib"/{etc,src}
  touch "$2/lib/rustlib/x86_64-unknown-linux-gnu/lib/libstd-0.rlib"
}

# put_wasm VERSION SYSROOT: a standard library for wasm32 that the compiler of a version made, and a linker.
put_wasm() {
  mkdir -p "$2/lib/rustlib/wasm32-unknown-unknown/lib"
  echo "$1" >"$2/lib/rustlib/wasm32-unknown-unknown/lib/libstd-0.rlib"
  program rust-lld 22.1 "$2/lib/rustlib/x86_64-unknown-linux-gnu/bin"
}

# put_rustup VERSION [ANSWER]: rustup with one toolchain; `rustup target add` adds, only answers, or fails.
put_rustup() {
  local folder=$machine/home/.cargo/bin
  put_rust "$1" "$toolchain"
  put rustup "$folder"
  echo "${2:-adds}" >"$machine/rustup/answer"
  local name
  for name in rustc cargo; do
    printf '#!/bin/sh\nexec "%s/bin/%s" "$@"\n' "$toolchain" "$name" >"$folder/$name"
    chmod +x "$folder/$name"
  done
}

# offer NAME VERSION [VERSION]: what the lists say, and what the archive has by now, if that is another.
offer() {
  echo "$2" >"$machine/lists/$1"
  echo "${3:-$2}" >"$machine/archive/$1"
}

# Lists of half a year ago, as on a machine's first day.
offer_debian_rust() {
  offer rustc-web "${1:-1.96.0+dfsg1-1}" "${2-}"
  offer cargo-web "${1:-1.96.0+dfsg1-1}" "${2-}"
  offer rust-web-src "${1:-1.96.0+dfsg1-1}" "${2-}"
  offer rust-web-clippy "${1:-1.96.0+dfsg1-1}" "${2-}"
  offer lld-22 22.1-1
}

# What the part wasm needs besides the Rust.
put_wasm_tools() {
  program wasm-bindgen 0.2.130
  put wasm-pack
  program wasm-opt "version 132"
}

# ---- running

# on_machine COMMAND…: there and nowhere else. $before comes first on PATH.
on_machine() {
  env -i PATH="${before:+$before:}$usr/bin:$real" HOME="$machine/home" XDG_CACHE_HOME="$machine/cache" \
    machine="$machine" real="$real" usr="$usr" toolchain="$toolchain" stand_ins="$stand_ins" real_node="$real_node" \
    RIVERSEED_SYSTEM="$usr" "${variables[@]}" "$@"
}
variables=()

set_up() { run on_machine "$checkout/scripts/setup.sh" "$@"; }
wasm_rust() { run on_machine "$checkout/scripts/env.sh" --wasm "$@"; }

# ---- judging

fail() {
  printf '%s\n' "$@" "--- status $status, output:" "$output" "--- calls:" "$(cat "$machine/calls")" >&2
  return 1
}
succeeded() { ((status == 0)) || fail "it failed"; }
failed() { ((status != 0)) || fail "it succeeded"; }
said() { [[ $output == *"$1"* ]] || fail "not said: $1"; }
never_said() { [[ $output != *"$1"* ]] || fail "said: $1"; }
# called TIMES BEGINNING
called() {
  local times
  times=$(grep -c "^$2" "$machine/calls" || true)
  ((times == $1)) || fail "'$2…' was called $times times, not $1"
}
forget_calls() { : >"$machine/calls"; }
