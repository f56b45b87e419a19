#!/usr/bin/env bash
# Tries what `make test` tries of every property, on fresh seeds and with all of its cases, again and again.
#
#   MINUTES=60 scripts/explore.sh [PROPERTY…]      10 minutes without; properties by name, or all of them
#
# For each failure it prints the smallest input that was found, and a line that tries the same cases again. Logs stay in
# target/explore. One failure or more: exit code 1.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

export minutes=${MINUTES:-10} logs=target/explore
[[ $minutes =~ ^[1-9][0-9]*$ ]] || { echo "MINUTES is '$minutes': a whole number from 1 on is needed" >&2; exit 2; }
for tool in nproc shuf timeout; do
  have $tool || { echo "The command '$tool' is missing: GNU coreutils have it." >&2; exit 1; }
done
export PROPTEST_DISABLE_FAILURE_PERSISTENCE=1 # or the first find would be found again and again
export PROPTEST_MAX_SHRINK_TIME=60000         # ms

# The names of a file's properties.
properties_of() {
  awk '/^ *proptest! \{$/ { indent = match($0, /[^ ]/); inside = 1; next }
    inside && /^ *\}$/ && match($0, /[^ ]/) == indent { inside = 0 }
    inside && match($0, /fn [a-z0-9_]+\(/) { print substr($0, RSTART + 3, RLENGTH - 4) }' "$@"
}

# A line for each property: the program it is in, what cargo calls that, its name.
list_properties() {
  local build program file of folder files
  build=$(cargo test --all-features --no-run 2>&1) || { echo "$build" >&2; return 1; }
  sed -n 's/^ *Executable \(unittests \)\?\([^ ]*\) (\(.*\))$/\3 \2/p' <<<"$build" | while read -r program file; do
    case $file in
      src/lib.rs) of=--lib; folder=src ;;
      ../../tests/all.rs) of=--test=all; folder=tests ;;
      tests/main.rs) of=--test=program; folder=crates/cli/tests ;;
      *) continue ;;
    esac
    files=$(grep -rl --include='*.rs' 'proptest! {' $folder) || continue
    # shellcheck disable=SC2086  # names of files, none with a space
    properties_of $files | sed "s|^|$program $of |"
  done
}

# try SEED END PROGRAM OF PROPERTY: until the clock says END, in seconds.
try() {
  local log=$logs/$5-$1.log left=$(($2 - $(date +%s))) status=0
  ((left > 0)) || return 0
  PROPTEST_RNG_SEED=$1 timeout "$left" "$3" "$5" --nocapture >"$log" 2>&1 || status=$?
  # Whoever is cut off by the clock has not failed, unless it was already looking for a smaller input.
  if ((status == 0)) || { ((status == 124)) && ! grep -q '^thread .* panicked' "$log"; }; then
    rm "$log"
    ((status != 0)) || echo "$5 $1" >>"$logs/passed"
    return
  fi
  printf 'FAILED %s\n' "$5"
  sed -n '/minimal failing input/,/^\t*successes/{/successes/!p}' "$log"
  printf '  again: PROPTEST_RNG_SEED=%s scripts/env.sh cargo test --all-features %s %s\n' "$1" "$4" "$5"
  mv "$log" "${log%.log}.failed"
}
export -f try

rm -rf "$logs"
mkdir -p "$logs"
touch "$logs/passed"
list_properties >"$logs/properties"
[[ -s $logs/properties ]] || { echo "Not one property was found among what 'cargo test --all-features --no-run' built." >&2; exit 1; }
if (($#)); then
  grep -E " ($(IFS='|'; echo "$*"))\$" "$logs/properties" >"$logs/chosen" || { echo "No property is called that." >&2; exit 2; }
  mv "$logs/chosen" "$logs/properties"
fi
echo "Exploring $(wc -l <"$logs/properties") properties for $minutes minutes."
end=$(($(date +%s) + 60 * minutes))
# Without an end: waiting for the slowest property of a round would explore nothing meanwhile.
while (($(date +%s) < end)); do
  shuf "$logs/properties" | while read -r property; do
    echo "$(od -An -N8 -tu8 /dev/urandom)" "$end" "$property"
  done
done | xargs -P "$(nproc)" -L 1 bash -c 'try "$@"' _
failed=$(find "$logs" -name '*.failed' | wc -l)
echo "$(wc -l <"$logs/passed") times a property held all of its cases, $failed times it did not; those logs are in $logs"
((failed == 0))
