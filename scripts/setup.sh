#!/usr/bin/env bash
# Gets what is missing and leaves alone what is there: a second run takes about a second.
#
#   scripts/setup.sh [rust] [lint] [wasm] [node] [browser] [firefox]      no names: all of them
#
#   rust      a compiler as new as Cargo.toml asks, and a linker
#   lint      rustfmt and clippy
#   wasm      the wasm32 target, wasm-bindgen (the version in Cargo.lock) and wasm-pack (the one in wasm-pack.toml)
#   node      Node.js, and the packages of www/package-lock.json
#   browser   Chromium and its driver
#   firefox   Firefox, the second engine
#
# System packages are asked of apt, where there is one; all else goes into ~/.cache/riverseed and www/node_modules.
# RIVERSEED_WASM=debian takes the wasm32 target from Debian's packages and never asks rustup for one.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

say() { printf '\033[1msetup:\033[0m %s\n' "$*"; }
die() {
  printf '\033[1msetup:\033[0m %s\n' "$@" >&2
  exit 1
}
have() { command -v "$1" >/dev/null; }

# Whether version $1 is at least version $2.
at_least() { [[ $(printf '%s\n' "$1" "$2" | sort -V | head -n 1) == "$2" ]]; }

# The first text in file $2 that looks like `$1 = "…"`.
value_of() { sed -n "s/^$1 *= *\"\([^\"]*\)\".*/\1/p" "$2" | head -n 1; }

as_root() { if ((EUID == 0)); then "$@"; else sudo "$@"; fi; }

# apt_get "WHAT FOR, HOW LONG" PACKAGE…   False when apt is not here or does not know them.
apt_get() {
  have apt-get || return 1
  say "installing ${*:2} ($1)"
  local install=(env DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends
    -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 "${@:2}")
  mkdir -p target
  as_root "${install[@]}" >target/apt.log 2>&1 ||
    { as_root apt-get update -qq && as_root "${install[@]}"; } >>target/apt.log 2>&1 ||
    { tail -n 3 target/apt.log >&2; return 1; }
}

# ---- rust

setup_rust() {
  have cargo || apt_get "1 minute" rustc-web cargo-web ||
    die "Rust is missing. Install it as https://rustup.rs says, then run this again."
  local wanted found
  wanted=$(value_of rust-version Cargo.toml)
  found=$(rustc --version | cut -d ' ' -f 2)
  at_least "$found" "$wanted" ||
    die "Rust $found is too old, $wanted or newer is needed: run 'rustup update stable', or see https://rustup.rs."
  have cc || apt_get "the linker, half a minute" gcc libc6-dev ||
    die "The linker 'cc' is missing. Install a C compiler, then run this again."
}

setup_lint() {
  setup_rust
  # Asked for their versions, since rustup leaves commands on PATH for parts that it has not got.
  if ! { cargo fmt --version && cargo clippy --version; } &>/dev/null; then
    { have rustup && rustup component add rustfmt clippy; } ||
      apt_get "rustfmt and clippy, 1 minute" rustfmt-web rust-web-clippy ||
      die "rustfmt or clippy is missing: get them with rustup, 'rustup component add rustfmt clippy' (https://rustup.rs)."
  fi
}

# ---- wasm

setup_wasm() {
  setup_rust
  (use_wasm_rust) || get_wasm_rust
  cargo_tool wasm-bindgen wasm-bindgen-cli "$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p;}' Cargo.lock)" 4
  cargo_tool wasm-pack wasm-pack "$(value_of wasm-pack wasm-pack.toml)" 3
}

get_wasm_rust() {
  if [[ ${RIVERSEED_WASM-} != debian ]] && have rustup; then
    say "getting the wasm32 target from rustup (half a minute)"
    rustup target add wasm32-unknown-unknown && return
  fi
  apt_get "a Rust that can compile to wasm32, 1 minute" rustc-web cargo-web rust-web-src rust-web-clippy ||
    die "The wasm32 target cannot be had here." \
      "  With rustup:  rustup target add wasm32-unknown-unknown" \
      "  On Debian:    its security updates, which hold the package rustc-web, must be among apt's sources"
  make_debian_rust
}

# Debian has no ready wasm32 standard library for this Rust, but its sources: they are compiled once, into a toolchain
# folder that is otherwise links to Debian's.
# shellcheck disable=SC2016  # the wrappers expand these, when they run
make_debian_rust() {
  local host llvm dir work new id tool
  host=$(/usr/bin/rustc -vV | sed -n 's/^host: //p')
  llvm=$(/usr/bin/rustc -vV | sed -n 's/^LLVM version: \([0-9]*\).*/\1/p')
  [[ -x /usr/bin/lld-$llvm ]] || apt_get "its linker" "lld-$llvm"

  say "compiling the standard library for wasm32 (1 minute)"
  dir=$(debian_rust)
  work=$RIVERSEED_CACHE/build
  new=$work/rust
  rm -rf "$work"
  mkdir -p "$work/src" "$new/bin" "$new/lib/rustlib/$host/bin" "$new/lib/rustlib/wasm32-unknown-unknown/lib"
  printf '[package]\nname = "empty"\nedition = "2021"\n' >"$work/Cargo.toml"
  echo '#![no_std]' >"$work/src/lib.rs"
  # The part `test` is for `cargo test`; the others make the target like any other, as does the bitcode, without which
  # nothing could be optimised across crates. -Z needs the bootstrap variable.
  (cd "$work" && RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc RUSTFLAGS="-C embed-bitcode=yes" CARGO_TARGET_DIR=$work/target \
    /usr/bin/cargo build --quiet --release --target wasm32-unknown-unknown \
    -Z build-std=std,panic_abort,panic_unwind,proc_macro,test)
  rm "$work"/target/wasm32-unknown-unknown/release/deps/libempty*
  cp "$work"/target/wasm32-unknown-unknown/release/deps/*.rlib "$new/lib/rustlib/wasm32-unknown-unknown/lib/"

  ln -s "/usr/lib/rustlib/$host/lib" "$new/lib/rustlib/$host/lib"
  ln -s /usr/lib/rustlib/etc /usr/lib/rustlib/src "$new/lib/rustlib/"
  ln -s "/usr/bin/lld-$llvm" "$new/lib/rustlib/$host/bin/rust-lld"
  ln -s /usr/bin/cargo "$new/bin/cargo"
  # These are not links: from a link, rustc would take Debian's own folder for its home. What rustc answers to -vV tells
  # cargo whether its earlier work still fits, and that depends on this standard library.
  id=$(cat "$new"/lib/rustlib/wasm32-unknown-unknown/lib/* | cksum)
  {
    wrapper "[ \"\$*\" != -vV ] || { /usr/bin/rustc -vV && echo 'standard library: $id'; exit; }"
    echo 'exec /usr/bin/rustc --sysroot "$home" "$@"'
  } >"$new/bin/rustc"
  wrapper 'exec /usr/bin/rustdoc --sysroot "$home" "$@"' >"$new/bin/rustdoc"
  for tool in cargo-clippy clippy-driver; do wrapper "SYSROOT=\$home exec /usr/bin/$tool \"\$@\"" >"$new/bin/$tool"; done
  chmod +x "$new"/bin/{rustc,rustdoc,cargo-clippy,clippy-driver}

  mv "$new" "$dir" # last, so that the folder is there whole or not at all
  rm -rf "$work"
}

# shellcheck disable=SC2016
wrapper() { printf '#!/bin/sh\nhome=$(dirname "$(dirname "$(readlink -f "$0")")")\n%s\n' "$1"; }

# cargo_tool COMMAND CRATE VERSION MINUTES: exactly this version.
cargo_tool() {
  [[ $("$1" --version 2>/dev/null) == "$1 $3" ]] && return
  say "compiling $2 $3 (about $4 minutes)"
  # Light optimisation: these programs run for a second. First with the crate's own lock file, then without, for a
  # registry that lacks a version it names.
  local install=(env CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_LTO=off
    CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 cargo install --quiet --force --root "$RIVERSEED_CACHE/tools" "$2@$3")
  "${install[@]}" --locked 2>/dev/null || "${install[@]}" || die "$2 $3 could not be installed: see cargo's words above."
}

# ---- node

setup_node() {
  local wanted=20.19 # what Vite asks
  if ! have node && [[ $(apt-cache policy nodejs 2>/dev/null) =~ Candidate:\ ([0-9.]+) ]] &&
    at_least "${BASH_REMATCH[1]}" $wanted; then
    apt_get "1 minute" nodejs npm || true
  fi
  have node || die "Node.js is missing. Install $wanted or newer (https://nodejs.org), then run this again."
  local found
  found=$(node --version)
  at_least "${found#v}" $wanted || die "Node.js ${found#v} is too old: $wanted or newer is needed (https://nodejs.org)."
  have npm || die "npm is missing: it comes with Node.js from https://nodejs.org, or as a package of its own."

  # What is installed is told by a copy of its lock file: file times say nothing in a fresh clone.
  cmp -s www/package-lock.json www/node_modules/.installed-lock.json && return
  say "installing the packages of www (half a minute)"
  # Not `npm ci`: it wants the lock file to know Biome's programs for every system, and not every registry has them all.
  npm --prefix www install --no-save --no-audit --no-fund --loglevel=error ||
    die "npm could not install the packages: see its words above."
  cp www/package-lock.json www/node_modules/.installed-lock.json
}

# ---- browsers

setup_browser() {
  [[ -n $CHROME && -n $CHROMEDRIVER ]] || apt_get "1 minute" chromium chromium-driver ||
    die "Chromium or chromedriver is missing. Install both, of one version, or name yours in CHROME and CHROMEDRIVER."
}

setup_firefox() {
  [[ -n $FIREFOX ]] || apt_get "half a minute" firefox-esr ||
    die "Firefox is missing. Install it, or name yours in FIREFOX."
}

# ----

# One at a time: two runs would build the same things twice.
mkdir -p "$RIVERSEED_CACHE"
if have flock; then
  exec 9>"$RIVERSEED_CACHE/lock"
  flock 9
fi

(($#)) || set -- rust lint wasm node browser firefox
for part; do
  declare -F "setup_$part" >/dev/null || die "no part is called '$part': rust, lint, wasm, node, browser, firefox"
  "setup_$part"
done
