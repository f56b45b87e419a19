#!/usr/bin/env bash
# Runs tests/hydrology.py on a riverseed program; skips it, with a word, where pysheds cannot be had.
#
#   scripts/hydrology.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/lib/python.sh

run_python_test hydrology "the test with a hydrology library of others" pysheds "$1"
