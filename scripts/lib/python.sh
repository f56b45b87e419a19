# shellcheck shell=bash
# Python with packages of others, in environments that are kept. Where it cannot be had, what would run in it is skipped: a script
# that sources this defines `skip WHY`, which says so and ends it.

# The packages named in the file WANTED, in the environment ENVIRONMENT: exactly those, once, and again if others are wanted or the
# machine's Python has gone. NAME is what they are called where they cannot be had.
#
#   get_python_packages ENVIRONMENT WANTED NAME
get_python_packages() {
  local environment=$1 wanted=$2 name=$3
  need_python
  cmp --silent "$wanted" "$environment/installed.txt" && finds_packages "$environment" && return
  rm -rf "$environment"
  python3 -m venv "$environment" &>/dev/null || skip "this machine has no Python with venv"
  # Not compiled: Python does that with what is used of them, which is little of the large ones.
  "$environment/bin/pip" install --quiet --disable-pip-version-check --retries 1 --no-compile --only-binary :all: -r "$wanted" ||
    skip "$name cannot be had from PyPI"
  cp "$wanted" "$environment/installed.txt"
}

# Whether an environment's Python is still there, and of the version that its packages were put in for.
finds_packages() { "$1/bin/python" -c "import pip" &>/dev/null; }

need_python() { command -v python3 >/dev/null || skip "this machine has no Python"; }

# Runs tests/NAME.py with the packages of tests/NAME.txt. WHAT is the test's name where it is skipped.
#
#   run_python_test NAME WHAT PACKAGE ARGUMENT…
run_python_test() {
  local name=$1 what=$2 package=$3
  shift 3
  skip() {
    echo "${what^} is skipped: $1."
    exit 0
  }
  get_python_packages "target/$name/venv" "tests/$name.txt" "$package"
  "target/$name/venv/bin/python" "tests/$name.py" "$@"
}
