# The parts wasm and bindgen: a Rust that compiles to wasm32, and the tools that make packages of what it compiles.
# shellcheck shell=bash

setup_wasm() {
  setup_bindgen
  cargo_tool wasm-pack "$(value_of wasm-pack wasm-pack.toml)" 3 wasm-pack
}

setup_bindgen() {
  setup_rust
  (use_wasm_rust) || get_wasm_rust
  local bindgen
  bindgen=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p;}' Cargo.lock)
  cargo_tool wasm-bindgen-cli "$bindgen" 3 wasm-bindgen
}

get_wasm_rust() {
  if [[ ${RIVERSEED_WASM-} != debian ]] && have rustup; then
    say "getting the wasm32 target from rustup (half a minute)"
    rustup target add wasm32-unknown-unknown || true
    # It may answer and yet not serve: it adds to a toolchain of its own, which is not always the one in use.
    (use_wasm_rust) && return
    say "that did not help: trying Debian's packages"
  fi
  local wanted
  wanted=$(wanted_rust)
  apt_get "a Rust that can compile to wasm32, 1 minute" \
    "rustc-web>=$wanted" "cargo-web>=$wanted" "rust-web-src>=$wanted" rust-web-clippy || true
  is_debian_rust_there ||
    die "The wasm32 target cannot be had here." \
      "  With rustup:  rustup target add wasm32-unknown-unknown (Rust $wanted or newer; https://rustup.rs)" \
      "  On Debian:    its security updates, which hold the package rustc-web, must be among apt's sources" \
      "  On Ubuntu:    its archive has no such package, take rustup"
  make_debian_rust
  (use_wasm_rust) || die "The Rust made in $(debian_rust) does not compile to wasm32. Remove that folder and try again."
}

# Whether what is installed will do, whatever apt said: it may be out of reach, with all that is needed here already.
is_debian_rust_there() { debian_rust >/dev/null && has_std_sources; }

# Debian has no ready wasm32 standard library for this Rust, but its sources: they are compiled once, into a toolchain
# folder that is otherwise links to Debian's.
make_debian_rust() {
  local host llvm dir work new
  host=$("$system/bin/rustc" -vV | sed -n 's/^host: //p')
  llvm=$("$system/bin/rustc" -vV | sed -n 's/^LLVM version: \([0-9]*\).*/\1/p')
  [[ -x $system/bin/lld-$llvm ]] || apt_get "its linker" "lld-$llvm" || die "The linker lld-$llvm of Debian's Rust is missing."

  say "compiling the standard library for wasm32 (1 minute)"
  dir=$(debian_rust)
  work=$(mktemp -d "$RIVERSEED_CACHE/build.XXXXXX") # its own: a run that was killed may have left a cargo at work
  new=$work/rust
  mkdir -p "$new/bin" "$new/lib/rustlib/$host/bin" "$new/lib/rustlib/wasm32-unknown-unknown/lib"
  compile_std "$work"
  cp "$work"/target/wasm32-unknown-unknown/release/deps/*.rlib "$new/lib/rustlib/wasm32-unknown-unknown/lib/"
  link_debian_rust "$new" "$host" "$llvm"
  wrap_debian_rust "$new"
  toolchain_contents "$new" >"$new/contents"

  rm -rf "$dir"     # what is left of one that broke
  mv "$new" "$dir"  # last, so that the folder is there whole or not at all
  rm -rf "$work"
}

# The part `test` is for `cargo test`; the others make the target like any other, as does the bitcode, without which
# nothing could be optimised across crates. -Z needs the bootstrap variable.
compile_std() {
  mkdir -p "$1/src"
  printf '[package]\nname = "empty"\nedition = "2021"\n[workspace]\n' >"$1/Cargo.toml"
  echo '#![no_std]' >"$1/src/lib.rs"
  (cd "$1" && env -u CARGO_ENCODED_RUSTFLAGS -u CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS \
    RUSTC_BOOTSTRAP=1 RUSTC="$system/bin/rustc" RUSTFLAGS="-C embed-bitcode=yes" CARGO_TARGET_DIR="$1/target" \
    "$system/bin/cargo" build --quiet --release --target wasm32-unknown-unknown \
    -Z build-std=std,panic_abort,panic_unwind,proc_macro,test)
  rm "$1"/target/wasm32-unknown-unknown/release/deps/libempty*
}

link_debian_rust() {
  ln -s "$system/lib/rustlib/$2/lib" "$1/lib/rustlib/$2/lib"
  ln -s "$system/lib/rustlib/etc" "$system/lib/rustlib/src" "$1/lib/rustlib/"
  ln -s "$system/bin/lld-$3" "$1/lib/rustlib/$2/bin/rust-lld"
  ln -s "$system/bin/cargo" "$1/bin/cargo"
}

# These are not links: from a link, rustc would take Debian's own folder for its home. What rustc answers to -vV tells
# cargo whether its earlier work still fits, and that depends on this standard library.
# shellcheck disable=SC2016  # the wrappers expand these, when they run
wrap_debian_rust() {
  local id tool
  id=$(cat "$1"/lib/rustlib/wasm32-unknown-unknown/lib/* | cksum)
  {
    wrapper "[ \"\$*\" != -vV ] || { $system/bin/rustc -vV && echo 'standard library: $id'; exit; }"
    echo "exec $system/bin/rustc --sysroot \"\$home\" \"\$@\""
  } >"$1/bin/rustc"
  wrapper "exec $system/bin/rustdoc --sysroot \"\$home\" \"\$@\"" >"$1/bin/rustdoc"
  for tool in cargo-clippy clippy-driver; do wrapper "SYSROOT=\$home exec $system/bin/$tool \"\$@\"" >"$1/bin/$tool"; done
  chmod +x "$1"/bin/{rustc,rustdoc,cargo-clippy,clippy-driver}
}

# shellcheck disable=SC2016
wrapper() { printf '#!/bin/sh\nhome=$(dirname "$(dirname "$(readlink -f "$0")")")\n%s\n' "$1"; }

# [features=NAMES] cargo_tool CRATE VERSION MINUTES COMMAND…: exactly this version of all its commands.
cargo_tool() {
  has_tools "$2" "${@:4}" && return
  say "compiling $1 $2 (about $3 minutes)"
  # Light optimisation: these programs run for a second. First with the crate's own lock file, then without, for a
  # registry that lacks a version it names.
  local install=(env CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_LTO=off
    CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 cargo install --quiet --force --root "$RIVERSEED_CACHE/tools" "$1@$2"
    ${features:+--features "$features"})
  "${install[@]}" --locked 2>/dev/null || "${install[@]}" || die "$1 $2 could not be installed: see cargo's words above."
  has_tools "$2" "${@:4}" || die "$1 $2 was installed, but does not answer: look at $RIVERSEED_CACHE/tools/bin."
}

has_tools() {
  local command
  for command in "${@:2}"; do [[ $(version_of "$command") == "$1" ]] || return; done
}
