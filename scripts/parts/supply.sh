# The part supply: what reads the licences of the crates.
# shellcheck shell=bash

setup_supply() {
  setup_rust
  features=cli cargo_tool cargo-about 0.9.3 3 cargo-about
  cargo_tool cargo-deny 0.20.2 5 cargo-deny
}
