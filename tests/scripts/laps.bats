# scripts/laps.sh: what time each part of a run has taken.

load machine
setup() {
  new_machine
  mkdir -p "$checkout/target"
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
  said "12 s      0 s of processors  Rust, natively"
  said "3 s      0 s of processors  the page"
  said "15 s      0 s of processors  in all"
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
  said "1 s      0 s of processors  in all"
}

@test "a part has the processor time that its make has spent on it, whichever make that is" {
  printf '1000 5 70 start\n1010 25 70 Rust\n1020 40 70 the page\n1030 8 71 Firefox\n' >"$checkout/target/laps"
  laps table
  said "10 s     20 s of processors  Rust"
  said "10 s     15 s of processors  the page"
  said "10 s      8 s of processors  Firefox"
  said "30 s     43 s of processors  in all"
}

@test "what make has run and ended counts, through the shells between" {
  cat >"$checkout/busy.mk" <<'END'
all:
	@scripts/laps.sh start
	-@bash -c 'ulimit -t 2; while :; do :; done'
	@bash -c 'scripts/laps.sh lap busy; true'
END
  run on_machine make --silent --directory "$checkout" --file busy.mk
  succeeded
  read -r _ spent make _ < <(tail -n 1 "$checkout/target/laps")
  ((make > 1 && spent >= 1)) || fail "$spent seconds of make $make"
}

@test "a part that is made by itself is not noted" {
  laps lap "alone"
  succeeded
  [[ ! -e $checkout/target/laps ]] || fail "it was noted"
}
