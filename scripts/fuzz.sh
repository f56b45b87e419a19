#!/usr/bin/env bash
# Gives foreign input to whatever reads it, for some seconds a target, and looks for what it promises never to do.
#
#   scripts/fuzz.sh SECONDS [TARGET…]      no names: all in fuzz/fuzz_targets
#
# With a nightly Rust, memory is watched too (AddressSanitizer); without one, panics and broken promises are found all
# the same. What is found lies in fuzz/artifacts, and a line that tries it again is printed; one find or more: exit code
# 1. Input that covers new code is kept in fuzz/corpus, and the next run goes on from there.
#
# scripts/setup.sh fuzz must have run.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

seconds=${1-}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || { echo "SECONDS is '$seconds': a whole number from 1 on is needed" >&2; exit 2; }
shift
known=(fuzz/fuzz_targets/*.rs)
known=("${known[@]##*/}")
known=("${known[@]%.rs}")
(($#)) || set -- "${known[@]}"
for target; do
  [[ " ${known[*]} " == *" $target "* ]] || { echo "no target is called '$target': ${known[*]}" >&2; exit 2; }
done

if nightly=$(rustup which --toolchain nightly rustc 2>/dev/null) && is_rust_new "$nightly"; then
  fuzz=(rustup run nightly cargo-fuzz)
  sanitizer=address
else
  echo "Memory is not watched: no nightly Rust is here that is new enough ('rustup toolchain install nightly')."
  export RUSTC_BOOTSTRAP=1 # for the flags that record which code is covered
  fuzz=(cargo-fuzz)
  sanitizer=none
fi

# Before any of them runs: a target that does not compile is no find.
for target; do "${fuzz[@]}" build --sanitizer "$sanitizer" "$target"; done

finds=0
for target; do
  mkdir -p "fuzz/corpus/$target"
  "${fuzz[@]}" run --sanitizer "$sanitizer" "$target" "fuzz/corpus/$target" "fuzz/seeds/$target" -- \
    -max_total_time="$seconds" -timeout=300 -rss_limit_mb=4096 -verbosity=0 -print_funcs=0 -print_final_stats=1 ||
    ((finds += 1))
done
echo "$finds of $# targets broke"
((finds == 0))
