#!/usr/bin/env bash
# The Python package: built as a wheel, installed and tested as its users have it. What that needs is kept in target/python; what
# checks and tests it is skipped, with a word, where that cannot be had, and a wheel is not: that fails.
#
#   scripts/python.sh check                          format, lint and types of its Python
#   scripts/python.sh try                            a wheel to try, compiled fast, into target/python/wheels
#   scripts/python.sh test target/debug/riverseed    the wheel, beside a riverseed program
#   scripts/python.sh wheel                          the wheel to publish, into target/package
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh
source scripts/lib/python.sh

build=target/python
element=www/dist-widget/river-seed.classic.js # what the widget of notebooks shows
packages=$build/venv
least_python=10 # of Python 3, as in python/pyproject.toml

skip() {
  echo "The Python package is not $done_with_it: $1."
  exit 0
}

# prepare DONE: what is done with it, such as "checked".
prepare() {
  done_with_it=$1
  need_python
  python3 -c "import sys; sys.exit(sys.version_info < (3, $least_python))" ||
    skip "this machine's Python is older than 3.$least_python"
  get_python_packages "$packages" python/requirements.txt "what that needs"
}

check() {
  "$packages/bin/ruff" check --quiet --no-cache python
  "$packages/bin/ruff" format --quiet --no-cache --check python
  "$packages/bin/mypy" --no-error-summary --cache-dir "$build/mypy" --config-file python/pyproject.toml python/riverseed python/tests
}

# Puts the element into the package with the notices of what is in it, if it has been built (make widget), and no old one if it has not.
put_element() {
  local folder=python/riverseed/static
  rm -f "$folder/${element##*/}" "$folder/THIRD-PARTY.txt"
  if [[ -f $element ]]; then cp "$element" THIRD-PARTY.txt "$folder"
  else echo "The Python package has no widget: there is no $element."; fi
}

# build_wheel FOLDER OPTION…
build_wheel() {
  put_element
  CARGO_TARGET_DIR=$PWD/$build "$packages/bin/maturin" build --quiet --locked --interpreter "$packages/bin/python" \
    --manifest-path python/Cargo.toml --out "$1" "${@:2}"
}

# Compiled fast, not to be fast.
try_wheel() {
  rm -rf "$build/wheels"
  build_wheel "$build/wheels" --profile dev --compatibility linux
}

install_wheel() {
  try_wheel
  "$packages/bin/pip" install --quiet --disable-pip-version-check --no-index --no-deps --force-reinstall "$build"/wheels/*.whl
}

case ${1-} in
  check)
    prepare checked
    check
    ;;
  try)
    prepare built
    try_wheel
    ;;
  test)
    prepare tested
    install_wheel
    "$packages/bin/stubtest" --concise --mypy-config-file python/pyproject.toml riverseed._native
    RIVERSEED_PROGRAM=$(realpath "$2") "$packages/bin/pytest" --quiet --config-file python/pyproject.toml \
      --doctest-modules --doctest-ignore-import-errors --pyargs riverseed python/tests
    ;;
  wheel)
    # Who asks for a wheel is not helped without one.
    skip() { echo "The Python package is not built: $1." >&2; exit 1; }
    prepare built
    build_wheel target/package --release
    ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
