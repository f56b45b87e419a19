# Which Rust to use, verified at every use: folders and links can outlive what was in them, and a compiler its standard
# library.
# shellcheck shell=bash

# Where Debian's packages put things; tests have a place of their own.
# shellcheck disable=SC2034  # the parts of set-up read it
system=${RIVERSEED_SYSTEM:-/usr}

wanted_rust() { value_of rust-version "$RIVERSEED_ROOT/Cargo.toml"; }

# Whether a compiler, by itself the one on PATH, is as new as Cargo.toml asks.
is_rust_new() { at_least "$(version_of "${1:-rustc}")" "$(wanted_rust)"; }

# A system's Rust that is too old gives way to rustup's, wherever that is on PATH.
prefer_newer_rust() {
  [[ -x $rustup_folder/rustc && $(command -v rustc) != "$rustup_folder/rustc" ]] || return 0
  is_rust_new || ! is_rust_new "$rustup_folder/rustc" || PATH=$our_tools:$rustup_folder:$PATH
}

# Whether the Rust on PATH makes wasm32 programs. It is asked to, which proves its standard library, that both are of one
# version, and the linker; it says why not.
compiles_to_wasm() {
  is_rust_new || return
  local folder failure=0
  folder=$(mktemp -d) || return
  rustc --target wasm32-unknown-unknown -o "$folder/empty.wasm" - <<<'fn main() {}' || failure=1
  rm -rf "$folder"
  return $failure
}

# Puts a Rust with wasm32 first on PATH: the one that is there, or rustup's, or our own. By PATH and not by
# RUSTUP_TOOLCHAIN, so that rustup's settings stay as they are and a machine without rustup works too.
use_wasm_rust() {
  compiles_to_wasm 2>/dev/null && return
  local rustc dir
  rustc=$(rustup which rustc 2>/dev/null) && use_if_wasm "${rustc%/*}" && return
  dir=$(debian_rust) && is_whole "$dir" && use_if_wasm "$dir/bin"
}

use_if_wasm() {
  local before=$PATH
  PATH=$1:$PATH
  compiles_to_wasm 2>/dev/null || { PATH=$before; return 1; }
}

# Whether the system's own Rust is new enough, and has what its standard library is compiled from.
has_std_sources() {
  is_rust_new "$system/bin/rustc" && [[ -x $system/bin/cargo && -e $system/lib/rustlib/src/rust ]]
}

# The folder of our own toolchain, made from Debian's Rust. It carries the package's version, because an update of the
# package makes the compiled standard library useless.
debian_rust() {
  local version
  version=$(package_version rustc-web)
  [[ -n $version ]] && echo "$RIVERSEED_CACHE/rust-wasm-${version//[^0-9A-Za-z.]/-}"
}

# Whether nothing of our toolchain is missing: a cleaner of caches takes single files too, and a removed package leaves
# links that lead nowhere.
is_whole() {
  [[ -x $1/bin/rustc && -x $1/bin/rustdoc && -x $1/bin/cargo && -e $1/contents ]] &&
    [[ $(toolchain_contents "$1") == "$(cat "$1/contents")" ]]
}

# The libraries of a toolchain of ours, for wasm32 with their sizes, for this machine by name.
toolchain_contents() {
  (cd "$1/lib/rustlib" 2>/dev/null && wc -c wasm32-unknown-unknown/lib/* && ls -- */lib/libstd-*) 2>/dev/null
}
