# scripts/fuzz.sh and the part fuzz: what is fuzzed, for how long, with which Rust, and what of it is a find.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  program c++ 12.2
  put cargo-fuzz
  sed -n 's/.*cargo_tool cargo-fuzz \([0-9.]*\) .*/\1/p' "$project/scripts/parts/explore.sh" >"$machine/cargo-fuzz-version"
  mkdir -p "$checkout/fuzz/fuzz_targets"
  touch "$checkout/fuzz/fuzz_targets/"{link,png}.rs
}

fuzz() { run on_machine "$checkout/scripts/fuzz.sh" "$@"; }
make_fuzz() { run on_machine make -C "$checkout" --no-print-directory fuzz "$@"; }

@test "all targets are fuzzed, each for as long as was said, from its corpus and its seeds" {
  fuzz 7
  succeeded
  said "0 of 2 targets broke"
  local target
  for target in link png; do
    called 1 "cargo-fuzz build $target,"
    called 1 "cargo-fuzz run $target,.* fuzz/corpus/$target fuzz/seeds/$target -- -max_total_time=7 "
    [[ -d $checkout/fuzz/corpus/$target ]]
  done
  called 2 "cargo-fuzz run"
}

@test "only the targets that are named are fuzzed" {
  fuzz 7 png
  succeeded
  said "0 of 1 targets broke"
  called 1 "cargo-fuzz run png"
  called 1 "cargo-fuzz run"
}

@test "a target that there is not is named, with those that there are, before anything is fuzzed" {
  fuzz 7 png pgn
  ((status == 2))
  said "no target is called 'pgn': link png"
  called 0 "cargo-fuzz"
  [[ ! -e $checkout/fuzz/corpus ]]
}

@test "seconds that are no whole number from 1 on are refused" {
  local seconds
  for seconds in "" 0 -1 1.5 ten 60s; do
    fuzz "$seconds"
    ((status == 2)) || fail "not refused: $seconds"
    said "SECONDS is '$seconds': a whole number from 1 on is needed"
  done
  called 0 "cargo-fuzz"
}

@test "without a nightly Rust memory is not watched, and that is said" {
  fuzz 7 link
  succeeded
  said "Memory is not watched"
  called 1 "cargo-fuzz run link, sanitizer none, toolchain , bootstrap 1"
}

@test "without rustup memory is not watched, and that is said" {
  rm -r "$machine/home/.cargo" "$machine/rustup"
  put_rust 1.95.0 "$usr"
  fuzz 7 link
  succeeded
  said "Memory is not watched"
  called 1 "cargo-fuzz run link, sanitizer none"
}

@test "with a nightly Rust memory is watched, by that Rust" {
  put_rust 1.98.0 "$toolchain-nightly"
  fuzz 7 link
  succeeded
  never_said "Memory is not watched"
  called 1 "cargo-fuzz build link, sanitizer address, toolchain nightly, bootstrap ,"
  called 1 "cargo-fuzz run link, sanitizer address, toolchain nightly, bootstrap ,"
}

@test "a nightly Rust that is too old does not fuzz" {
  put_rust 1.80.0 "$toolchain-nightly"
  fuzz 7 link
  succeeded
  said "Memory is not watched"
  called 1 "cargo-fuzz run link, sanitizer none, toolchain ,"
}

@test "a find is told and arrives at the caller, and the other targets are fuzzed all the same" {
  touch "$machine/breaks-link"
  fuzz 7
  ((status == 1))
  said "fuzz/artifacts/link/crash-1"
  said "1 of 2 targets broke"
  called 1 "cargo-fuzz run png"
}

@test "a target that does not compile is no find: nothing is fuzzed" {
  touch "$machine/does-not-compile-png"
  fuzz 7
  ((status == 101))
  said "could not compile png"
  never_said "broke"
  called 0 "cargo-fuzz run"
}

@test "make fuzz hands on seconds and targets, and the failure" {
  make_fuzz
  succeeded
  called 2 "cargo-fuzz run .* -max_total_time=60 "
  touch "$machine/breaks-png"
  make_fuzz SECONDS=7 TARGETS=png
  failed
  called 1 "cargo-fuzz run png,.* -max_total_time=7 "
  called 1 "cargo-fuzz run .* -max_total_time=7 "
}

@test "make fuzz without a C++ compiler is left out with a word" {
  rm "$usr/bin/c++" "$usr/bin/apt-get"
  make_fuzz
  succeeded
  said "The compiler 'c++' is missing"
  said "Fuzzing is left out"
  called 0 "cargo-fuzz"
}

@test "the C++ compiler and cargo-fuzz are got once" {
  rm "$usr/bin/c++" "$usr/bin/cargo-fuzz"
  offer g++ 12.2
  set_up fuzz
  succeeded
  set_up fuzz
  succeeded
  called 1 "apt-get install g++"
  called 1 "cargo install cargo-fuzz@$(cat "$machine/cargo-fuzz-version")"
}
