# The parts rust and lint.
# shellcheck shell=bash

setup_rust() {
  is_rust_there || get_rust
  can_link || apt_get "the linker, half a minute" gcc libc6-dev || true
  can_link || die "The linker 'cc' is missing or cannot link. Install a C compiler (on Debian and Ubuntu the packages" \
    "  gcc and libc6-dev), then run this again."
}

is_rust_there() { is_rust_new && [[ -n $(version_of cargo) ]]; }

get_rust() {
  local wanted
  wanted=$(wanted_rust)
  # A Rust that somebody put here by other means than apt stays in front on PATH, whatever apt installs.
  comes_from_elsewhere rustc || apt_get "1 minute" "rustc-web>=$wanted" "cargo-web>=$wanted" || true
  is_rust_there && return
  have rustc || die "Rust is missing. Install it as https://rustup.rs says, then run this again."
  local found
  found=$(version_of rustc)
  [[ -n $found ]] || die "$(command -v rustc) does not run; it says: $(rustc --version 2>&1 | head -n 1)" \
    "  Rustup without a toolchain: run 'rustup default stable', then this again."
  is_rust_new || die "Rust $found ($(command -v rustc)) is too old, $wanted or newer is needed:" \
    "  run 'rustup update stable', or install it as https://rustup.rs says, then run this again."
  die "cargo is missing beside Rust $found ($(command -v rustc)). Install Rust as https://rustup.rs says, then run this again."
}

# Whether a command is there, but not where the system's packages put theirs.
comes_from_elsewhere() { have "$1" && [[ $(command -v "$1") != "$system"/bin/* && $(command -v "$1") != /bin/* ]]; }

# A compiler alone does not link: the C library's start files are a package of their own.
can_link() {
  mkdir -p target
  cc -x c -o target/.linked - <<<'int main(void) { return 0; }' 2>/dev/null
}

setup_lint() {
  setup_rust
  has_lint || ! have rustup || rustup component add rustfmt clippy || true
  has_lint || apt_get "rustfmt and clippy, 1 minute" rustfmt-web rust-web-clippy || true
  has_lint || die "rustfmt or clippy is missing: get them with rustup, 'rustup component add rustfmt clippy' (https://rustup.rs)."
  has_wasm_lint || apt_get "clippy for wasm32, half a minute" rust-web-clippy || true
  has_wasm_lint || die "clippy is missing beside the Rust that compiles to wasm32: on Debian the package rust-web-clippy has it."
  [[ -n $(version_of shellcheck) ]] || apt_get "it reads the scripts, half a minute" shellcheck || true
  [[ -n $(version_of shellcheck) ]] || die "shellcheck is missing: see https://www.shellcheck.net, then run this again."
}

# Asked for their versions, since rustup leaves commands on PATH for parts that it has not got.
has_lint() { { cargo fmt --version && cargo clippy --version; } &>/dev/null; }

# The Rust for wasm32 may be another one, with a clippy of its own. Where there is none yet, none is missed.
has_wasm_lint() { (! use_wasm_rust || cargo clippy --version &>/dev/null); }
