# The parts fuzz and mutants: what looks for faults beyond the tests. Not among those that a set-up without names gets.
# shellcheck shell=bash

setup_fuzz() {
  setup_rust
  have c++ || apt_get "a C++ compiler for libFuzzer, half a minute" g++ ||
    die "The compiler 'c++' is missing, which libFuzzer needs."
  cargo_tool cargo-fuzz 0.13.2 2 cargo-fuzz
}

setup_mutants() {
  setup_rust
  cargo_tool cargo-mutants 27.1.0 4 cargo-mutants
}
