# The part wasm: a Rust that really compiles to wasm32, and tools of exactly one version.

load machine
setup() {
  new_machine
  put_wasm_tools
}

# A machine whose wasm32 comes from Debian, set up.
debian_machine() {
  offer_debian_rust
  set_up wasm
  succeeded
  made=$(echo "$machine"/cache/riverseed/rust-wasm-*)
  forget_calls
}

# Whether set-up mends what a test broke, by making the toolchain again, and then rests.
mends() {
  wasm_rust rustc --version
  failed
  said "run scripts/setup.sh wasm"
  set_up wasm
  succeeded
  called 1 "cargo build std"
  wasm_rust rustc --version
  succeeded
  set_up wasm
  called 1 "cargo build std"
}

@test "Debian's Rust is made into a toolchain with wasm32, once" {
  debian_machine
  wasm_rust rustc -vV
  said "rustc 1.96.0"
  said "standard library: "
  set_up wasm
  succeeded
  [[ ! -s $machine/calls ]] || fail "it set up again"
}

@test "a Rust of half a year ago is never made into a toolchain" {
  offer_debian_rust 1.85.0 1.96.0
  set_up wasm
  succeeded
  wasm_rust rustc --version
  said "rustc 1.96.0"
}

@test "a Rust that is too old is not used, though it compiles to wasm32" {
  put_rustup 1.85.0
  put_wasm 1.85.0 "$toolchain"
  wasm_rust rustc --version
  failed
  said "run scripts/setup.sh wasm"
}

@test "a package that was removed and left its settings is not installed" {
  version() { run on_machine bash -c 'source "$0/scripts/lib/versions.sh" && package_version rustc-web' "$checkout"; }
  mkdir "$machine/removed"
  echo 1.96.0 >"$machine/removed/rustc-web"
  version
  succeeded
  [[ $output == "" ]]
  echo 1.96.0 >"$machine/installed/rustc-web"
  version
  [[ $output == 1.96.0 ]]
}

@test "an old Debian Rust beside a new rustup is renewed before a toolchain is made of it" {
  put_rustup 1.95.0
  before=$machine/home/.cargo/bin
  variables=(RIVERSEED_WASM=debian)
  "$stand_ins/unpack" rustc-web 1.85.0
  offer_debian_rust 1.85.0 1.96.0
  set_up wasm
  succeeded
  called 0 "rustup target add"
  wasm_rust rustc --version
  said "rustc 1.96.0"
}

@test "an emptied toolchain folder is made again" {
  debian_machine
  rm -r "${made:?}"/*
  mends
}

@test "a toolchain that lost one library is made again" {
  debian_machine
  rm "$made/lib/rustlib/wasm32-unknown-unknown/lib/libtest-0.rlib"
  mends
}

@test "a toolchain with a library cut short is made again" {
  debian_machine
  : >"$made/lib/rustlib/wasm32-unknown-unknown/lib/libcore-0.rlib"
  mends
}

@test "a linker that was removed by autoremove comes back" {
  debian_machine
  rm "$usr/bin/lld-22" "$machine/installed/lld-22"
  mends
  called 1 "apt-get install lld-22"
}

@test "a Debian Rust that was removed comes back" {
  debian_machine
  mkdir "$machine/removed"
  mv "$machine/installed/rustc-web" "$machine/removed/"
  rm -r "$usr/lib/rustlib" "$usr/bin/rustc"
  put_rustup 1.95.0 fails
  variables=(RIVERSEED_WASM=debian)
  mends
}

@test "an update of Debian's Rust gets a toolchain of its own" {
  debian_machine
  "$stand_ins/unpack" rustc-web 1.97.0
  echo 1.97.0 >"$machine/installed/rustc-web"
  mends
}

@test "a toolchain of an older package is not used for a newer compiler" {
  debian_machine
  "$stand_ins/unpack" rustc-web 1.97.0 # and the package's number stays
  mends
}

@test "a standard library that another compiler made does not count as there" {
  put_rustup 1.95.0
  put_wasm 1.94.0 "$toolchain"
  set_up wasm
  succeeded
  called 1 "rustup target add"
}

@test "a toolchain folder without its library does not count as there" {
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  rm "$toolchain/lib/rustlib/wasm32-unknown-unknown/lib/"*
  set_up wasm
  succeeded
  called 1 "rustup target add"
}

@test "rustup adds the target, and apt is not asked" {
  put_rustup 1.95.0
  set_up wasm
  succeeded
  called 0 "apt-get"
  wasm_rust rustc --version
  said "rustc 1.95.0"
}

@test "a rustup that answers and adds nothing is followed by Debian" {
  put_rustup 1.95.0 answers
  offer_debian_rust 1.85.0 1.96.0
  set_up wasm
  succeeded
  said "trying Debian's packages"
  wasm_rust rustc --version
  said "rustc 1.96.0"
}

@test "a rustup that fails is followed by Debian" {
  put_rustup 1.95.0 fails
  offer_debian_rust
  set_up wasm
  succeeded
  wasm_rust rustc --version
  said "rustc 1.96.0"
}

@test "rustup's target serves although the system's Rust is first on PATH" {
  put_rust 1.91.0 "$usr"
  put_rustup 1.95.0
  set_up wasm
  succeeded
  called 1 "rustup target add"
  wasm_rust rustc --version
  succeeded
  said "rustc 1.95.0"
  set_up wasm
  called 1 "rustup target add"
}

@test "with RIVERSEED_WASM=debian rustup is not asked" {
  put_rustup 1.95.0
  offer_debian_rust
  variables=(RIVERSEED_WASM=debian)
  set_up wasm
  succeeded
  called 0 "rustup target add"
}

@test "a machine that has neither is told of rustup, Debian and Ubuntu" {
  put_rustup 1.95.0 fails
  set_up wasm
  failed
  said "rustc-web not at all"
  said "rustup target add wasm32-unknown-unknown"
  said "On Ubuntu"
}

@test "a Rust of Debian's without its sources makes no toolchain where the archive has none" {
  "$stand_ins/unpack" rustc-web 1.96.0
  "$stand_ins/unpack" cargo-web 1.96.0
  echo 1.96.0 >"$machine/installed/rustc-web"
  set_up wasm
  failed
  said "rust-web-src not at all"
  said "The wasm32 target cannot be had here"
  called 0 "cargo build std"
}

@test "lists are refreshed once in a run, however many packages are missed" {
  offer_debian_rust 1.85.0 1.96.0
  rm "$machine/lists/lld-22" "$machine/archive/lld-22"
  set_up wasm
  failed
  said "lld-22 not at all"
  called 1 "apt-get update"
}

@test "a standard library that does not compile leaves no toolchain, and the next run tries again" {
  offer_debian_rust
  touch "$machine/std-fails"
  set_up wasm
  failed
  [[ ! -e $(echo "$machine"/cache/riverseed/rust-wasm-*) ]]
  rm "$machine/std-fails"
  set_up wasm
  succeeded
}

@test "flags of the user's do not reach the standard library" {
  offer_debian_rust
  variables=(RUSTFLAGS=-Cfoo CARGO_ENCODED_RUSTFLAGS=-Cbar)
  set_up wasm
  succeeded
  called 1 "cargo build std RUSTFLAGS=-C embed-bitcode=yes$"
}

@test "wasm-bindgen of another version is replaced by the one in Cargo.lock" {
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  program wasm-bindgen 0.2.100
  set_up wasm
  succeeded
  called 1 "cargo install wasm-bindgen-cli@0.2.130"
  called 0 "cargo install wasm-pack"
}

@test "a tool that was installed and does not answer is a sentence" {
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  rm "$usr/bin/wasm-bindgen"
  touch "$machine/install-does-nothing"
  set_up wasm
  failed
  said "wasm-bindgen-cli 0.2.130 was installed, but does not answer"
}

@test "RUSTFLAGS is left out of what is built for wasm32, and said to be" {
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  variables=(RUSTFLAGS=-Ctarget-cpu=native CARGO_ENCODED_RUSTFLAGS=-Cbar)
  wasm_rust bash -c 'echo "flags: ${RUSTFLAGS-none} ${CARGO_ENCODED_RUSTFLAGS-none}"'
  said "RUSTFLAGS is left out here"
  said "flags: none none"
  run on_machine "$checkout/scripts/env.sh" bash -c 'echo "flags: $RUSTFLAGS"'
  said "flags: -Ctarget-cpu=native"
}
