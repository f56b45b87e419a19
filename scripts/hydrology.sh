#!/usr/bin/env bash
# Runs tests/hydrology.py and the recipes of docs/hydrology.md on a riverseed program; skips them, with a word, where pysheds cannot be had.
#
#   scripts/hydrology.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/lib/python.sh

run_python_test hydrology "the test with a hydrology library of others" pysheds "$1"
target/hydrology/venv/bin/python tests/hydrology_recipes.py "$1"
