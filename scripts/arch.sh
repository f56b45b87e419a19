#!/usr/bin/env bash
# The same bits on another family of processors: builds the command line for 64-bit ARM and lets it verify the committed
# digests in an emulator. Some minutes, so not part of `make test`.
#
#   scripts/arch.sh
#
# The standard library is rustup's, where rustup can add the target; elsewhere, on Debian, it is compiled from its
# sources. RIVERSEED_WASM=debian never asks rustup. scripts/setup.sh rust must have run.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh
source scripts/lib/apt.sh

say() { printf '\033[1march:\033[0m %s\n' "$*"; }
die() {
  printf '\033[1march:\033[0m %s\n' "$@" >&2
  exit 1
}

target=aarch64-unknown-linux-gnu
linker=aarch64-linux-gnu-gcc
library=$system/aarch64-linux-gnu

main() {
  is_emulator_there || get_emulator
  build=(cargo build --package riverseed-cli)
  if use_rustup; then
    say "with rustup's Rust and its standard library for $target"
  else
    has_std_sources || get_debian_rust
    say "with Debian's Rust, and the standard library from its sources"
    # -Z needs the bootstrap variable.
    build=(env RUSTC_BOOTSTRAP=1 RUSTC="$system/bin/rustc" "$system/bin/cargo" build --package riverseed-cli
      -Z "build-std=std,panic_unwind,proc_macro")
  fi
  verify
}

is_emulator_there() { have $linker && have qemu-aarch64 && [[ -e $library/lib/libc.so.6 ]]; }

get_emulator() {
  apt_get "a linker, a C library and an emulator for 64-bit ARM, 1 minute" \
    gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user || true
  is_emulator_there ||
    die "The linker $linker, its C library ($library) or the emulator qemu-aarch64 is missing:" \
      "  install them, then run this again."
}

# Puts the toolchain that rustup adds the target to first on PATH: another Rust may be there now.
use_rustup() {
  local rustc
  [[ ${RIVERSEED_WASM-} != debian ]] && rustc=$(rustup which rustc 2>/dev/null) && is_rust_new "$rustc" || return
  rustup target add $target && PATH=${rustc%/*}:$PATH
}

get_debian_rust() {
  local wanted
  wanted=$(wanted_rust)
  apt_get "a Rust with the sources of its standard library, 1 minute" \
    "rustc-web>=$wanted" "cargo-web>=$wanted" "rust-web-src>=$wanted" || true
  has_std_sources || die "No Rust here compiles to $target. With rustup (https://rustup.rs): 'rustup target add $target'."
}

# Built as the release is, but for optimisation across crates, which takes minutes.
verify() {
  export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/arch
  export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=$linker
  export CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
  say "building the command line for $target"
  "${build[@]}" --quiet --release --locked --target $target --bin riverseed
  say "verifying the committed digests"
  qemu-aarch64 -L "$library" "$CARGO_TARGET_DIR/$target/release/riverseed" verify
}

main
