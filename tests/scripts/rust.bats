# The parts rust and lint: which compiler is used, and what is asked of apt.

load machine
setup() { new_machine; }

@test "package lists of half a year ago are refreshed before anything is installed" {
  offer_debian_rust 1.85.0+dfsg3-1 1.96.0+dfsg1-1
  set_up rust
  succeeded
  said "refreshing apt's package lists"
  called 1 "apt-get update"
  called 1 "apt-get install rustc-web cargo-web"
  [[ $(cat "$machine/installed/rustc-web") == 1.96.0+dfsg1-1 ]]
}

@test "lists that offer what is needed are left as they are" {
  offer_debian_rust
  set_up rust
  succeeded
  called 0 "apt-get update"
}

@test "an archive that has only an old Rust is said to, once asked, and nothing is installed" {
  offer_debian_rust 1.63.0 1.85.0
  set_up rust
  failed
  called 1 "apt-get update"
  called 0 "apt-get install"
  said "rustc-web 1.85.0, wanted: rustc-web>=1.90"
  said "https://rustup.rs"
}

@test "Debian's Rust that was installed before, and is too old, is renewed" {
  "$stand_ins/unpack" rustc-web 1.85.0
  "$stand_ins/unpack" cargo-web 1.85.0
  offer_debian_rust
  set_up rust
  succeeded
  [[ $(cat "$usr/rust-version") == 1.96.0 ]]
}

@test "a package that the archive has replaced since is found by refreshing the lists" {
  offer_debian_rust 1.95.0 1.96.0
  touch "$machine/only-the-newest"
  set_up rust
  succeeded
  called 1 "apt-get update"
  [[ $(cat "$machine/installed/rustc-web") == 1.96.0 ]]
}

@test "lists that another program is refreshing are waited for" {
  offer_debian_rust 1.85.0 1.96.0
  touch "$machine/lists-locked"
  set_up rust
  succeeded
  called 1 "sleep 10"
  called 2 "apt-get update"
}

@test "nothing that somebody else installed is removed for ours" {
  "$stand_ins/unpack" rustc-web 1.63.0
  offer_debian_rust
  touch "$machine/would-remove"
  set_up rust
  failed
  said "remove is disabled"
  said "Rust 1.63.0 ($usr/bin/rustc) is too old, 1.90 or newer is needed"
  [[ ! -e $machine/installed/rustc-web ]]
}

@test "a rustup whose Rust is too old is told to be updated, and apt is left alone" {
  put_rustup 1.85.0
  offer_debian_rust
  set_up rust
  failed
  said "rustup update stable"
  called 0 "apt-get"
}

@test "a rustup without a toolchain is told what to do, in its own words and ours" {
  put_rustup ""
  set_up rust
  failed
  said "rustup could not choose a version"
  said "rustup default stable"
}

@test "a system's Rust that is too old gives way to rustup's behind it on PATH" {
  put_rust 1.63.0 "$usr"
  put_rustup 1.95.0
  set_up rust
  succeeded
  called 0 "apt-get"
  run on_machine "$checkout/scripts/env.sh" rustc --version
  said "rustc 1.95.0"
}

@test "a linker that lacks the C library's files gets them" {
  put_rustup 1.95.0
  rm "$usr/lib/crt1.o"
  offer gcc 12.2
  offer libc6-dev 2.36
  set_up rust
  succeeded
  called 1 "apt-get install gcc libc6-dev"
}

@test "without apt, a missing Rust is a sentence" {
  rm "$usr/bin/apt-get" "$usr/bin/apt-cache"
  set_up rust
  failed
  said "Rust is missing. Install it as https://rustup.rs says"
}

@test "rustfmt and clippy that rustup says it added, and did not, come from Debian or are a sentence" {
  put_rustup 1.95.0 answers
  set_up lint
  failed
  called 1 "rustup component add rustfmt clippy"
  said "rustfmt or clippy is missing"
}

@test "the clippy of the Rust for wasm32 is asked for too, and shellcheck" {
  put_rustup 1.95.0
  touch "$toolchain/has-fmt" "$toolchain/has-clippy"
  before=$machine/home/.cargo/bin
  offer_debian_rust
  variables=(RIVERSEED_WASM=debian)
  put_wasm_tools
  set_up wasm
  rm "$usr/has-clippy"
  offer shellcheck 0.9.0
  set_up lint
  succeeded
  called 1 "apt-get install rust-web-clippy"
  called 1 "apt-get install shellcheck"
}
