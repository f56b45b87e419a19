# scripts/laps.sh: what time each part of a run has taken.

load machine
setup() {
  new_machine
  put date
  at 1000
}

at() { echo "$1" >"$machine/now"; }
laps() { run on_machine "$checkout/scripts/laps.sh" "$@"; }

@test "each part has the time since the last one, and all together theirs" {
  laps start
  at 1012
  laps lap "Rust, natively"
  at 1015
  laps lap "the page"
  at 1019
  laps table
  succeeded
  said "12 s  Rust, natively"
  said "3 s  the page"
  said "15 s  in all"
}

@test "a new run forgets the last one" {
  laps start
  at 1500
  laps lap "long ago"
  laps start
  at 1501
  laps lap "now"
  laps table
  never_said "long ago"
  said "1 s  in all"
}

@test "a part that is made by itself is not noted" {
  laps lap "alone"
  succeeded
  [[ ! -e $checkout/target/laps ]] || fail "it was noted"
}
