#!/usr/bin/env bash
# The crates that this one depends on: the notices that their licences ask for, and which of them may be used.
#
#   scripts/supply.sh notices    writes THIRD-PARTY.txt: the notices of every crate in a program or package of ours
#   scripts/supply.sh check      the notices are current; licences, sources and duplicates of crates are as
#                                .cargo/deny.toml allows; no advisory is known, if their database can be reached
#
# scripts/setup.sh supply must have run.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

# notices FILE. All crates are looked at, also those for other machines, which no build here has fetched.
notices() {
  cargo fetch --quiet --locked
  cargo about generate --frozen --all-features --fail --config .cargo/about.toml --output-file "$1" .cargo/about.hbs
}

check_notices() {
  local now=target/THIRD-PARTY.txt
  mkdir -p target
  notices "$now"
  diff --brief THIRD-PARTY.txt "$now" || { echo "THIRD-PARTY.txt is out of date: run 'make notices'" >&2; return 1; }
}

# The database of advisories is a git repository, which not every machine can reach.
check_advisories() {
  local said
  said=$(cargo deny --log-level warn check advisories 2>&1) && return
  if grep --quiet --ignore-case 'failed to fetch advisory database' <<<"$said"; then
    echo "Advisories are not looked up: their database cannot be reached from here."
  else
    echo "$said" >&2
    return 1
  fi
}

case ${1-} in
  notices) notices THIRD-PARTY.txt ;;
  check)
    check_notices
    cargo deny --frozen --log-level warn check licenses bans sources
    check_advisories
    ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
