# scripts/explore.sh: which properties are tried, on which seeds, for how long, and what of it is a failure.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  local name
  for name in date timeout nproc; do put $name; done
  echo 0 >"$machine/now"
  echo 3 >"$machine/runs"
  mkdir "$checkout/tests"
  properties "$checkout/src/land.rs" land_has_a_shore
  properties "$checkout/tests/growth.rs" rivers_end rivers_join
  cp "$stand_ins/test-program" "$machine/unit-tests"
  cp "$stand_ins/test-program" "$machine/growth-tests"
  printf '  Executable %s (%s)\n' "unittests src/lib.rs" "$machine/unit-tests" "unittests src/bin/main.rs" "$machine/main" \
    "../../tests/all.rs" "$machine/growth-tests" >"$machine/programs"
}

# properties FILE NAME…: a file with these properties, and a function beside them.
properties() {
  printf 'fn helper(x: u8) {}\nproptest! {\n' >"$1"
  printf '    #[test]\n    fn %s(x in 0..9u8) {}\n' "${@:2}" >>"$1"
  printf '}\nfn other(x: u8) {}\n' >>"$1"
}

# fails NAME CODE LINE…: how a property ends, and what it prints.
fails() {
  echo "$2" >"$machine/$1.exit"
  printf '%b\n' "${@:3}" >"$machine/$1.log"
}

explore() { run on_machine env MINUTES="${minutes-2}" "$checkout/scripts/explore.sh" "$@"; }

@test "every property is tried, and nothing else" {
  explore
  succeeded
  said "Exploring 3 properties for 2 minutes."
  said "3 times a property held all of its cases, 0 times it did not"
  called 3 "property"
  called 1 "property land_has_a_shore"
  called 1 "property rivers_end"
  called 1 "property rivers_join"
}

@test "each try has a seed of its own" {
  echo 9 >"$machine/runs"
  explore
  succeeded
  (($(sed -n 's/^property.*seed= *\([0-9]\{1,\}\)$/\1/p' "$machine/calls" | sort -u | wc -l) == 9)) || fail "no seed, or one twice"
}

@test "a try ends when the minutes are over, and none begins after them" {
  explore
  succeeded
  called 3 "timeout 120"
  called 3 "timeout"
}

@test "only the properties that are named are tried" {
  echo 2 >"$machine/runs"
  explore rivers_end land_has_a_shore
  succeeded
  said "Exploring 2 properties"
  called 0 "property rivers_join"
}

@test "a name that no property has is refused" {
  explore rivers
  ((status == 2))
  said "No property is called that."
  called 0 "property"
}

@test "minutes that are no whole number from 1 on are refused" {
  for minutes in 0 -1 1.5 ten "1 "; do
    explore
    ((status == 2)) || fail "not refused: $minutes"
    said "MINUTES is '$minutes': a whole number from 1 on is needed"
  done
}

@test "a failure is told with its smallest input and a line that tries it again, and arrives at the caller" {
  fails rivers_join 101 "thread 'rivers_join' panicked" "minimal failing input: x = 7" "\tsuccesses: 3" "unrelated"
  explore
  ((status == 1))
  said "FAILED rivers_join"
  said "minimal failing input: x = 7"
  never_said "unrelated"
  local seed
  seed=$(sed -n 's/^property rivers_join seed= *//p' "$machine/calls")
  said "PROPTEST_RNG_SEED=$seed scripts/env.sh cargo test --all-features --test=all rivers_join"
  said "2 times a property held all of its cases, 1 times it did not"
  grep -q "unrelated" "$checkout/target/explore/rivers_join-$seed.failed"
}

@test "a failure of the library's own tests is tried again among those" {
  fails land_has_a_shore 101 "thread 'land_has_a_shore' panicked"
  explore
  ((status == 1))
  said "scripts/env.sh cargo test --all-features --lib land_has_a_shore"
}

@test "a property that time cuts off has neither held nor failed" {
  fails rivers_end 124
  explore
  succeeded
  said "2 times a property held all of its cases, 0 times it did not"
}

@test "a property that time cuts off while it looks for a smaller input has failed" {
  fails rivers_end 124 "thread 'rivers_end' panicked at tests/growth.rs"
  explore
  ((status == 1))
  said "FAILED rivers_end"
}

@test "failures of the last time are not counted again" {
  fails rivers_end 101
  explore
  failed
  rm "$machine"/rivers_end.*
  forget_calls
  echo 0 >"$machine/now"
  explore
  succeeded
}

@test "tests that do not compile are told in cargo's words" {
  touch "$machine/tests-do-not-compile"
  explore
  failed
  said "could not compile riverseed"
  never_said "Exploring"
}

@test "to find no property at all is a failure" {
  : >"$machine/programs"
  explore
  failed
  said "Not one property was found"
}

@test "a library whose own tests hold no property leaves those of the other programs" {
  echo 'pub fn land() {}' >"$checkout/src/land.rs"
  echo 2 >"$machine/runs"
  explore
  succeeded
  said "Exploring 2 properties"
}

@test "a command that is missing is named" {
  rm "$usr/bin/timeout"
  explore
  failed
  said "The command 'timeout' is missing"
}
