#!/usr/bin/env bash
# The Python package in notebooks: the widget in JupyterLab and marimo in a real browser, and the example notebook with the packages that
# it plots with. Skipped, with a word, where those or the element cannot be had.
#
#   scripts/notebooks.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh
source scripts/lib/python.sh

build=target/notebooks
packages=$build/venv
least_python=11 # of Python 3: that of the packages, not ours

skip() {
  echo "The Python package is not tested in notebooks: $1."
  exit 0
}

need_python
python3 -c "import sys; sys.exit(sys.version_info < (3, $least_python))" || skip "this machine's Python is older than 3.$least_python"
[[ -f www/dist-widget/river-seed.classic.js ]] || skip "the element is not built (make widget)"
[[ -n $HEADLESS_SHELL ]] || skip "this machine has no Chromium"
get_python_packages "$packages" python/requirements-notebooks.txt "JupyterLab, marimo or what goes with them"
scripts/python.sh try
compgen -G "target/python/wheels/*.whl" >/dev/null || skip "there is no wheel"
"$packages/bin/pip" install --quiet --disable-pip-version-check --no-index --no-deps --force-reinstall target/python/wheels/*.whl
# Two at a time: most of them wait for a browser.
NOTEBOOKS=$PWD/$packages node --test --test-concurrency=2 --test-timeout=300000 python/tests/notebooks/*.test.mjs
