#!/usr/bin/env bash
# Proves everything that no landing waits for, and prints the line that says so in docs/nightly.txt. It goes on after a failure, to find all.
#
#   scripts/nightly.sh [TARGET…]   these targets of make; by itself all of them
set -uo pipefail
cd "$(dirname "$0")/.." || exit

(($#)) || set -- check supply test-all test-arch newest explore fuzz mutants
commit=$(git rev-parse --short=12 HEAD)
failed=()
for target; do
  make "$target" || failed+=("$target")
done
result="all passed: $*"
((${#failed[@]} == 0)) || result="FAILED: ${failed[*]}"
echo
echo "For docs/nightly.txt:"
echo "$commit $(date -u +%Y-%m-%d) $result"
((${#failed[@]} == 0))
