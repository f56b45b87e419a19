#!/usr/bin/env bash
# One at a time: two runs would build the same things twice, or one into the other's.
#
#   scripts/lib/lock.sh FILE "WHAT" COMMAND…    runs a command while it holds FILE; says that it waits for WHAT
#
# Where there is no flock, commands run unlocked.

# take_lock FILE WHAT: holds FILE until this shell ends, as descriptor 9. Close that in what is started (9>&-): a program
# left behind in the background would hold it too.
take_lock() {
  mkdir -p "$(dirname "$1")"
  command -v flock >/dev/null || return 0
  exec 9>"$1"
  flock -n 9 && return
  printf '\033[1mwaiting:\033[0m %s is at work\n' "$2"
  flock 9
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  set -euo pipefail
  take_lock "$1" "$2"
  "${@:3}" 9>&-
fi
