# shellcheck shell=bash
# Tests in Python with packages of others: each has an environment of its own.

# Runs tests/NAME.py with the packages of tests/NAME.txt, which it keeps in target/NAME. Where they cannot be had, it skips the
# test, with a word, and ends the script.
#
#   run_python_test NAME "the test with …" PACKAGE ARGUMENT…
run_python_test() {
  local name=$1 what=$2 package=$3
  shift 3
  local venv=target/$name/venv wanted=tests/$name.txt
  command -v python3 >/dev/null || skip_test "$what" "this machine has no Python"
  # Exactly what is wanted was installed once.
  cmp --silent "$wanted" "$venv/installed.txt" || install_packages
  "$venv/bin/python" "tests/$name.py" "$@"
}

install_packages() {
  rm -rf "$venv"
  python3 -m venv "$venv" &>/dev/null || skip_test "$what" "this machine has no Python with venv"
  "$venv/bin/pip" install --quiet --disable-pip-version-check --retries 1 --only-binary :all: -r "$wanted" ||
    skip_test "$what" "$package cannot be had from PyPI"
  cp "$wanted" "$venv/installed.txt"
}

skip_test() {
  echo "${1^} is skipped: $2."
  exit 0
}
