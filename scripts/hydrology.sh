#!/usr/bin/env bash
# Runs tests/hydrology.py on a riverseed program, with the packages that it needs in target/hydrology; skips it, with a word,
# where they cannot be had.
#
#   scripts/hydrology.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."

packages=target/hydrology/venv
wanted=tests/hydrology.txt

skip() {
  echo "The test with a hydrology library of others is skipped: $1."
  exit 0
}

# Whether exactly what is wanted was installed once.
is_there() { cmp --silent "$wanted" "$packages/installed.txt"; }

install_packages() {
  rm -rf "$packages"
  python3 -m venv "$packages" &>/dev/null || skip "this machine has no Python with venv"
  "$packages/bin/pip" install --quiet --disable-pip-version-check --retries 1 --only-binary :all: -r "$wanted" ||
    skip "pysheds cannot be had from PyPI"
  cp "$wanted" "$packages/installed.txt"
}

command -v python3 >/dev/null || skip "this machine has no Python"
is_there || install_packages
"$packages/bin/python" tests/hydrology.py "$1"
