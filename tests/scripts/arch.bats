# scripts/arch.sh: with which Rust and which emulator the digests are verified on another family of processors.

load machine
setup() {
  new_machine
  offer gcc-aarch64-linux-gnu 12.2
  offer libc6-dev-arm64-cross 2.36
  offer qemu-user 7.2
}

put_emulator() {
  local package
  for package in gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user; do "$stand_ins/unpack" $package 7.2; done
}

verify() { run on_machine "$checkout/scripts/arch.sh"; }

@test "the linker, the C library and the emulator are installed once" {
  put_rustup 1.95.0
  verify
  succeeded
  verify
  succeeded
  called 1 "apt-get install gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user"
}

@test "a linker without its C library gets it" {
  put_rustup 1.95.0
  put_emulator
  rm "$usr/aarch64-linux-gnu/lib/libc.so.6"
  verify
  succeeded
  called 1 "apt-get install"
}

@test "without apt, a missing emulator is a sentence" {
  put_rustup 1.95.0
  rm "$usr/bin/apt-get"
  verify
  failed
  said "the emulator qemu-aarch64 is missing"
  called 0 "cargo build"
}

@test "packages that are installed and do not hold the emulator are not taken for it" {
  put_rustup 1.95.0
  printf '#!/bin/sh\n' >"$usr/bin/apt-get"
  verify
  failed
  said "the emulator qemu-aarch64 is missing"
}

@test "the toolchain that rustup adds the target to builds, though a system's Rust is first on PATH" {
  put_emulator
  put_rust 1.95.0 "$usr"
  put_rustup 1.95.0
  verify
  succeeded
  said "with rustup's Rust"
  called 1 "rustup target add aarch64-unknown-linux-gnu"
  called 1 "cargo build for ARM: $toolchain, aarch64-linux-gnu-gcc"
  called 1 "qemu-aarch64 verify"
}

@test "a rustup that cannot add the target is followed by Debian" {
  put_emulator
  put_rustup 1.95.0 fails
  offer_debian_rust 1.85.0 1.96.0
  verify
  succeeded
  said "with Debian's Rust"
  called 1 "apt-get update"
  called 1 "apt-get install rustc-web cargo-web rust-web-src"
  called 1 "cargo build for ARM: $usr, bootstrap, aarch64-linux-gnu-gcc"
}

@test "a rustup whose Rust is too old is followed by Debian" {
  put_emulator
  put_rustup 1.85.0
  offer_debian_rust
  verify
  succeeded
  called 0 "rustup target add"
  called 1 "cargo build for ARM: $usr, bootstrap"
}

@test "with RIVERSEED_WASM=debian rustup is not asked for the ARM target, and a Rust with its sources is not got again" {
  put_emulator
  put_rustup 1.95.0
  before=$machine/home/.cargo/bin
  offer_debian_rust
  variables=(RIVERSEED_WASM=debian)
  verify
  succeeded
  verify
  succeeded
  called 0 "rustup target add"
  called 1 "apt-get install rustc-web"
  called 2 "cargo build for ARM: $usr, bootstrap"
}

@test "a Rust of Debian's that lacks sources or cargo, or is too old, is got again" {
  put_emulator
  offer_debian_rust
  variables=(RIVERSEED_WASM=debian)
  "$stand_ins/unpack" rustc-web 1.96.0
  "$stand_ins/unpack" cargo-web 1.96.0
  verify
  succeeded
  called 1 "apt-get install rustc-web"
  rm "$usr/bin/cargo"
  verify
  succeeded
  called 2 "apt-get install rustc-web"
  "$stand_ins/unpack" rustc-web 1.85.0
  verify
  succeeded
  called 3 "apt-get install rustc-web"
}

@test "a machine that has neither is told of rustup and its target" {
  put_emulator
  put_rustup 1.95.0 fails
  offer_debian_rust 1.63.0 1.85.0
  verify
  failed
  said "rustc-web 1.85.0, wanted: rustc-web>=1.90"
  said "'rustup target add aarch64-unknown-linux-gnu'"
  called 0 "cargo build"
}

@test "a program that does not compile is not run, and the failure arrives" {
  put_emulator
  put_rustup 1.95.0 answers # and adds nothing
  verify
  ((status == 101))
  said "can't find crate"
  called 0 "qemu-aarch64"
}

@test "digests that differ arrive at the caller as they are" {
  put_emulator
  put_rustup 1.95.0
  touch "$machine/digests-differ"
  verify
  ((status == 3))
  said "gives other bits"
}
