#!/usr/bin/env bash
# Runs tests/batch.py, the program of docs/batch.md on a local cluster, on a riverseed program; skips it, with a word, where Dask cannot
# be had.
#
#   scripts/batch.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/lib/python.sh

run_python_test batch "the test with a distributed engine" Dask "$1"
