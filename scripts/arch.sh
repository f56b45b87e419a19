#!/usr/bin/env bash
# The same bits on another family of processors: builds the command line for 64-bit ARM, with a standard library from its
# sources, and lets it verify the committed digests in an emulator. Some minutes, so not part of `make test`.
#
#   scripts/arch.sh        on Debian, or wherever rustup has the target aarch64-unknown-linux-gnu
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
library=/usr/aarch64-linux-gnu

# ---- what it takes

if ! have $linker || ! have qemu-aarch64 || [[ ! -e $library/lib/libc.so.6 ]]; then
  apt_get "a linker, a C library and an emulator for 64-bit ARM, 1 minute" \
    gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user ||
    die "The linker $linker, its C library or the emulator qemu-aarch64 is missing: install them, then run this again."
fi

# By rustup, which has the target ready-made; otherwise by Debian's Rust, whose sources are compiled with the program.
build=(cargo build)
if [[ ${RIVERSEED_WASM-} != debian ]] && have rustup && rustup target add $target; then
  say "with rustup's Rust"
else
  { is_rust_new /usr/bin/rustc && [[ -e /usr/lib/rustlib/src/rust/library/std ]]; } ||
    apt_get "a Rust with the sources of its standard library, 1 minute" \
      "rustc-web>=$(wanted_rust)" "cargo-web>=$(wanted_rust)" rust-web-src ||
    die "No Rust here compiles to $target: see https://rustup.rs, 'rustup target add $target'."
  say "with Debian's Rust, and the standard library from its sources"
  # -Z needs the bootstrap variable.
  build=(env RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc /usr/bin/cargo build -Z "build-std=std,panic_unwind,proc_macro")
fi

# ---- build and verify

# As the release is built, but for optimisation across crates, which takes minutes.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/arch
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=$linker
export CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
say "building the command line for $target"
"${build[@]}" --quiet --release --locked --target $target --bin riverseed
say "verifying the committed digests"
qemu-aarch64 -L $library "$CARGO_TARGET_DIR/$target/release/riverseed" verify
