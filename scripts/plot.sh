#!/usr/bin/env bash
# Runs tests/plot.py on a riverseed program; skips it, with a word, where vpype cannot be had.
#
#   scripts/plot.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/lib/python.sh

run_python_test plot "the test with the software of plotters" vpype "$1"
