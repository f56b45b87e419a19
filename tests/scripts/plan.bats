# scripts/plan.mjs and scripts/suite.sh: which tests a landing runs, and that none is ever lost.

load machine
setup() {
  new_machine
  clone=$BATS_TEST_TMPDIR/clone
  mkdir -p "$clone"/{docs,scripts,tests,src,www/node_modules}
  cp -R "$project/scripts/plan.mjs" "$project/scripts/lib" "$clone/scripts"
  cp -R "$project/www/node_modules/smol-toml" "$clone/www/node_modules"
  echo '{}' >"$clone/www/package.json"
  echo /www >"$clone/.gitignore"
  cat >"$clone/docs/ci.toml" <<'END'
hours = 6
nightly = 3
parts = [
  { make = "always", minutes = 1, always = true },
  { make = "gis", minutes = 2 },
  { make = "python", minutes = 3 },
  { make = "firefox", minutes = 4 },
]
[shares]
rust = 2
[paths]
"docs" = {}
"scripts" = {}
"src" = {}
"src/relief" = { rust = "relief hypsometry", parts = "gis" }
"tests" = {}
".gitignore" = {}
END
  : >"$clone/tests/seconds.txt"
  now=1700000000
  git -C "$clone" init --quiet
  change docs/a
  now=$((now + 86400))
}

# change PATH: a commit that touches it, a minute after the last one.
change() {
  mkdir -p "$(dirname "$clone/$1")"
  echo "$now" >>"$clone/$1"
  git -C "$clone" add --all
  GIT_AUTHOR_DATE="$now +0000" GIT_COMMITTER_DATE="$now +0000" \
    git -C "$clone" -c user.name=A -c user.email=a@localhost -c commit.gpgsign=false commit --quiet --message="$1"
  now=$((now + 60))
}

plan() { run env "${variables[@]}" "$real_node" "$clone/scripts/plan.mjs" "$@"; }
parts() { variables=(RIVERSEED_ROOT="$clone"); plan parts; }
# tests NAME…: those that are chosen of the tests with these names.
tests() { chosen=$(printf '%s\n' "$@" | RIVERSEED_ROOT=$clone SHARE=${share-} "$real_node" "$clone/scripts/plan.mjs" tests rust 2>"$BATS_TEST_TMPDIR/why"); }
# named KEY: the words that rows of docs/ci.toml have under it.
named() { grep -oE "$1 = \"[^\"]*\"" "$project/docs/ci.toml" | sed 's/.* = //; s/"//g' | tr ' ' '\n'; }
# A part is printed with its minutes.
has() { grep --quiet --extended-regexp --line-regexp "$1 [0-9]+" <<<"$output" || fail "no line $1"; }

@test "what always runs runs, what is touched runs, and of the rest one part, in turn" {
  change src/relief/solver.rs
  parts
  succeeded
  has always
  has gis
  said "make gis: touched: src/relief"
  turns=0
  for part in python firefox; do ! grep --quiet "make $part: its turn" <<<"$output" || turns=$((turns + 1)); done
  ((turns <= 1)) || fail "$turns parts in turn"
}

@test "every part has its turn" {
  seen=
  for _ in 1 2 3; do
    change docs/a
    parts
    seen+=$output
  done
  for part in gis python firefox; do [[ $seen == *"make $part: its turn"* ]] || fail "$part had no turn"; done
}

@test "commits of the hours before count, and older ones do not" {
  change src/relief/solver.rs
  now=$((now + 3600))
  change docs/a
  parts
  said "touched: src/relief"
  now=$((now + 8 * 3600))
  change docs/a
  change docs/a
  parts
  never_said "touched: src/relief"
}

@test "a path that no row names runs everything" {
  change surprise.txt
  parts
  for part in always gis python firefox; do has "$part"; done
  tests a::b c::d relief::e
  [[ $(wc -l <<<"$chosen") == 3 ]] || fail "chosen: $chosen"
}

@test "what touches nothing with a name runs no more than its share" {
  change docs/a
  tests a::b c::d
  [[ $(wc -l <<<"$chosen") == 1 ]] || fail "chosen: $chosen"
}

@test "a clone without its history runs everything" {
  change docs/a
  git clone --quiet --depth 1 "file://$clone" "$clone-shallow"
  cp -R "$clone/www" "$clone-shallow"
  variables=(RIVERSEED_ROOT="$clone-shallow")
  plan parts
  for part in always gis python firefox; do has "$part"; done
}

@test "tests of what was touched run in every share, and a touched file of tests runs itself" {
  change src/relief.rs
  change tests/shapes.rs
  for share in 1/2 2/2; do
    tests relief::a hypsometry::b shapes::c other::d another::e
    for test in relief::a hypsometry::b shapes::c; do grep --quiet "$test" <<<"$chosen" || fail "no $test in $share"; done
  done
}

@test "the shares together are all tests, each once, whatever times are recorded, and take about the same time" {
  change docs/a
  names=()
  for i in {1..40}; do
    names+=("m$((i % 7))::test_$i")
    ((i % 3 == 0)) || echo "$i.5 m$((i % 7))::test_$i" >>"$clone/tests/seconds.txt"
  done
  echo "99 gone::test" >>"$clone/tests/seconds.txt"
  all=
  for share in 1/2 2/2; do
    tests "${names[@]}"
    all+=$chosen$'\n'
    times+=("$(awk 'NR == FNR { time[$2] = $1; next } { sum += time[$1] } END { print int(sum) }' "$clone/tests/seconds.txt" - <<<"$chosen")")
  done
  [[ $(sed '/^$/d' <<<"$all" | sort) == "$(printf '%s\n' "${names[@]}" | sort)" ]] || fail "the shares are not all: $all"
  ((times[0] - times[1] < 60 && times[1] - times[0] < 60)) || fail "unequal shares: ${times[*]}"
}

@test "SHARE=all is everything, and a share that is none is named with those there are" {
  change docs/a
  share=all tests a::b c::d e::f
  [[ $(wc -l <<<"$chosen") == 3 ]] || fail "chosen: $chosen"
  ! share=3/2 tests a::b || fail "3/2 was taken"
  grep --quiet "one of 1/2 to 2/2" "$BATS_TEST_TMPDIR/why" || fail "$(cat "$BATS_TEST_TMPDIR/why")"
}

@test "the other shares are named with the command that runs them" {
  change docs/a
  tests a::b
  grep --quiet "SHARE=1/2 to 2/2" "$BATS_TEST_TMPDIR/why"
}

@test "a nightly run that is missed is the first thing that is said" {
  change docs/a
  echo "$(git -C "$clone" rev-parse --short=12 HEAD) 2026-01-01 all passed" >"$clone/docs/nightly.txt"
  change docs/a
  parts
  never_said "NIGHTLY MISSED"
  for _ in 1 2 3 4; do change docs/a; done
  parts
  [[ ${lines[0]} == "NIGHTLY MISSED: 5 commits"* ]] || fail "first: ${lines[0]}"
}

@test "every name in docs/ci.toml is there: parts, modules of tests, specs; and every part has its minutes" {
  grep 'make = ' "$project/docs/ci.toml" | grep --invert-match 'minutes = [0-9]' && fail "a part without minutes"
  make=$(grep -oE '^[a-z-]+:' "$project/Makefile")
  while read -r part; do
    grep --quiet "^$part:" <<<"$make" || fail "make has no $part"
  done < <(named make; named parts)
  while read -r spec; do
    [[ -e $project/www/tests/e2e/$spec.spec.ts ]] || fail "no spec $spec"
  done < <(named browser)
  while read -r module; do
    compgen -G "$project/crates/*/tests/$module.rs" >/dev/null || [[ -d $project/src/$module || -d $project/tests/$module ]] ||
      [[ -e $project/src/$module.rs || -e $project/tests/$module.rs ]] || fail "no module $module"
  done < <(named rust)
  while read -r path; do
    [[ -e $project/$path || -e $project/$path.rs ]] || fail "no path $path"
  done < <(sed -n '/^\[paths\]/,$s/^"\([^"]*\)" = .*/\1/p' "$project/docs/ci.toml")
}

@test "CI begins a part only if it may end in time, and says which it leaves to the night" {
  mkdir -p "$clone/.ci" "$clone/bin"
  cp "$project/.ci/run" "$clone/.ci"
  printf '#!/bin/sh\necho "make $*" >>"$CALLS"\n' >"$clone/bin/make"
  for script in setup kept laps; do printf '#!/bin/sh\n' >"$clone/scripts/$script.sh"; done
  chmod +x "$clone"/{bin/make,scripts/*.sh}
  change surprise.txt
  calls=$BATS_TEST_TMPDIR/ran
  ci() { : >"$calls" && run env CALLS="$calls" RIVERSEED_ROOT="$clone" PATH="$clone/bin:$PATH" "$@" "$clone/.ci/run"; }
  ci
  succeeded
  [[ $(cat "$calls") == $'make check test\nmake always\nmake gis\nmake python\nmake firefox' ]] || fail "$(cat "$calls")"
  ci SECONDS=$((86 * 60))
  succeeded
  [[ $(cat "$calls") == $'make check test\nmake always\nmake gis' ]] || fail "$(cat "$calls")"
  said "make python is left to the night: it may take 3 minutes, and this machine took 86 so far, of 88"
  said "make firefox is left to the night"
}

@test "a suite runs the tests that were chosen by their names, and one that is lost on the way is a failure" {
  cp -R "$project/scripts" "$clone"
  mkdir -p "$clone/bin"
  cat >"$clone/bin/cargo" <<'END'
#!/usr/bin/env bash
echo "$*" >>"$CALLS"
[[ $* != *--list* ]] || { printf 'a::b: test\nc::d: test\n'; exit; }
echo "test result: ok. ${PASSED} passed; 0 failed"
END
  chmod +x "$clone/bin/cargo"
  change docs/a
  export CALLS=$BATS_TEST_TMPDIR/calls
  PASSED=2 PATH=$clone/bin:$PATH run "$clone/scripts/suite.sh" rust
  succeeded
  grep --quiet -- "--exact a::b c::d" "$CALLS" || fail "$(cat "$CALLS")"
  PASSED=1 PATH=$clone/bin:$PATH run "$clone/scripts/suite.sh" rust
  failed
  said "2 tests were chosen and 1 passed"
}
