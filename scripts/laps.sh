#!/usr/bin/env bash
# How long each part of a run of make takes, and what processor time.
#
#   scripts/laps.sh start        the clock runs from now
#   scripts/laps.sh lap PART     PART has just ended: the time since the last part was its own
#   scripts/laps.sh table        prints each part with its seconds by the clock and its processor seconds, and the sums
#
# A part that is made by itself, without a start before it, is not noted.
set -euo pipefail
cd "$(dirname "$0")/.."

laps=target/laps # a line each: when it ended and the processor time until then, both in seconds, the make that ran it, and what it was

# The processor time of everything that the make above has run and ended, in seconds, and the number of that make. Where there is no /proc,
# or no make: nothing, 0.
spent() {
  local process=$PPID stat fields
  while ((process > 1)) && [[ -r /proc/$process/stat ]]; do
    stat=$(<"/proc/$process/stat")
    read -ra fields <<<"${stat##*) }" # from the third on: names may have spaces
    if [[ $(<"/proc/$process/comm") == make ]]; then
      echo "$(((fields[13] + fields[14]) / $(getconf CLK_TCK 2>/dev/null || echo 100))) $process"
      return
    fi
    process=${fields[1]}
  done
  echo "0 0"
}

case ${1-} in
  start)
    mkdir -p target
    echo "$(date +%s) $(spent) start" >"$laps"
    ;;
  lap)
    [[ ! -e $laps ]] || echo "$(date +%s) $(spent) $2" >>"$laps"
    ;;
  table)
    echo
    # Another make begins to count from nothing.
    awk 'NR == 1 { first = before = $1; spent = $2; make = $3; next }
      { now = $1; own = $3 == make ? $2 - spent : $2; spent = $2; make = $3; sum += own
        sub(/^[0-9]+ [0-9]+ [0-9]+ /, ""); printf "  %6d s %6d s of processors  %s\n", now - before, own, $0; before = now }
      END { printf "  %6d s %6d s of processors  in all\n", before - first, sum }' "$laps"
    ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
