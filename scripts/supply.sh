#!/usr/bin/env bash
# The crates that this one depends on: the notices that their licences ask for, and which of them may be used.
#
#   scripts/supply.sh notices    writes THIRD-PARTY.txt: the notices of every crate in a program or package of ours;
#                                and that of the Python package
#   scripts/supply.sh check      the notices are current; licences, sources and duplicates of crates are as
#                                .cargo/deny.toml allows; no advisory is known, if their database can be reached
#
#   scripts/supply.sh passed     says whether the very same files have passed that check before: .cargo/passed, which is committed with
#                                them, spares every other machine the tools, which take minutes to compile. `make nightly` checks again
#
# scripts/setup.sh supply must have run, but for `passed`.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

# What is handed out, each with a Cargo.lock and notices of its own.
folders=(. python)

# notices FOLDER FILE. All crates are looked at, also those for other machines, which no build here has fetched.
notices() {
  cargo fetch --quiet --locked --manifest-path "$1/Cargo.toml"
  cargo about generate --frozen --workspace --all-features --fail --manifest-path "$1/Cargo.toml" --config .cargo/about.toml \
    --output-file "$2" .cargo/about.hbs
}

check_notices() {
  local now=target/THIRD-PARTY.txt file=$1/THIRD-PARTY.txt
  file=${file#./}
  mkdir -p target
  notices "$1" "$now"
  diff --brief "$file" "$now" || { echo "$file is out of date: run 'make notices'" >&2; return 1; }
}

# A name for all that these checks read.
digest() {
  { cat .cargo/*.* scripts/supply.sh {.,python,crates/*}/Cargo.toml {.,python}/{Cargo.lock,THIRD-PARTY.txt} 2>/dev/null || true; } |
    sha256sum | cut -c 1-20
}

# A duplicate that one of the two has is none of the other's.
check_licences() {
  cargo deny --frozen --workspace --manifest-path "$1/Cargo.toml" --config .cargo/deny.toml --log-level warn check --allow unmatched-skip \
    licenses bans sources
}

# The database of advisories is a git repository, which not every machine can reach.
check_advisories() {
  local said
  said=$(cargo deny --workspace --manifest-path "$1/Cargo.toml" --config .cargo/deny.toml --log-level warn check advisories 2>&1) && return
  if grep --quiet --ignore-case 'failed to fetch advisory database' <<<"$said"; then
    echo "Advisories are not looked up: their database cannot be reached from here."
  else
    echo "$said" >&2
    return 1
  fi
}

case ${1-} in
  notices) for folder in "${folders[@]}"; do notices "$folder" "$folder/THIRD-PARTY.txt"; done ;;
  check)
    for folder in "${folders[@]}"; do
      check_notices "$folder"
      check_licences "$folder"
    done
    for folder in "${folders[@]}"; do check_advisories "$folder"; done
    digest >.cargo/passed
    ;;
  passed)
    [[ -e .cargo/passed && $(<.cargo/passed) == "$(digest)" ]]
    echo "Licences and notices are as they were when they last passed."
    ;;
  *) sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
