#!/usr/bin/env bash
# How long each part of a run of make takes.
#
#   scripts/laps.sh start        the clock runs from now
#   scripts/laps.sh lap PART     PART has just ended: the time since the last part was its own
#   scripts/laps.sh table        prints each part with its seconds, and the sum
#
# A part that is made by itself, without a start before it, is not noted.
set -euo pipefail
cd "$(dirname "$0")/.."

laps=target/laps # a line each: when it ended, in seconds, and what it was

case ${1-} in
  start)
    mkdir -p target
    echo "$(date +%s) start" >"$laps"
    ;;
  lap)
    [[ ! -e $laps ]] || echo "$(date +%s) $2" >>"$laps"
    ;;
  table)
    echo
    awk 'NR == 1 { first = before = $1; next }
      { now = $1; sub(/^[0-9]+ /, ""); printf "  %6d s  %s\n", now - before, $0; before = now }
      END { printf "  %6d s  in all\n", before - first }' "$laps"
    ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
