#!/usr/bin/env bash
# Runs the slow tests of a suite: all of them, or with SHARE those that scripts/plan.mjs chooses. They are built once, listed, and run by
# name; that as many have run as were chosen is verified.
#
#   scripts/suite.sh rust       the tests with `#[ignore]`
#   scripts/suite.sh browser    those without @core in their titles; www/dist and www/dist-widget must be there
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

mkdir -p target
list=target/$1-tests log=target/$1-tests.log
export SHARE=${SHARE:-all}

chosen() { node scripts/plan.mjs tests "$1" <"$list" >"$list.chosen"; }

# A name can stand for tests of several programs, so the names are counted as they are listed.
rust() {
  cargo test --quiet --all-features --tests -- --ignored --list --format terse | sed -n 's/: test$//p' >"$list"
  chosen rust
  local names expected
  mapfile -t names < <(sort -u "$list.chosen")
  expected=$(wc -l <"$list.chosen")
  ((expected > 0)) || return 0
  cargo test --all-features --tests --no-fail-fast -- --ignored --exact "${names[@]}" | tee "$log"
  verify "$expected" "$(sed -n 's/^test result: ok\. \([0-9]*\) passed.*/\1/p' "$log" | awk '{ sum += $1 } END { print sum + 0 }')"
}

browser() {
  PORT=$(free_port)
  export PORT
  (cd www && playwright test --list --grep-invert @core) | sed -n 's/^  *\([^ ].*\.spec\.ts:.*\)$/\1/p' | sed 's/:[0-9]*:[0-9]* ›/ ›/' >"$list"
  chosen browser
  (($(wc -l <"$list.chosen") > 0)) || return 0
  (cd www && playwright test --test-list "../$list.chosen") | tee "$log"
  verify "$(wc -l <"$list.chosen")" "$(sed -n 's/^ *\([0-9]*\) passed.*/\1/p' "$log" | tail -n 1)"
}

free_port() { node -e 'require("net").createServer().listen(0, "127.0.0.1", function () { console.log(this.address().port); this.close() })'; }

verify() {
  (($1 == $2)) || { echo "$1 tests were chosen and ${2:-none} passed: a test was lost on the way" >&2; exit 1; }
}

case ${1-} in
  rust | browser) "$1" ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
