# scripts/python.sh: when the Python package is left out.

load machine
setup() {
  new_machine
  mkdir "$checkout/python"
  echo "numpy==2.2.6" >"$checkout/python/requirements.txt"
}

python_sh() { run on_machine "$checkout/scripts/python.sh" "$@"; }

# put_python VERSION-SWITCH: what `python3 -c` answers, 0 for a Python that is new enough. Its venv has a pip without any packages.
put_python() {
  cat >"$usr/bin/python3" <<EOF
#!/bin/sh
case "\$1 \$2" in
  "-m venv")
    mkdir -p "\$3/bin"
    printf '#!/bin/sh\necho "No matching distribution found" >&2\nexit 1\n' >"\$3/bin/pip"
    chmod +x "\$3/bin/pip" ;;
  *) exit $1 ;;
esac
EOF
  chmod +x "$usr/bin/python3"
}

@test "without Python it is left out, with a word" {
  python_sh check
  succeeded
  said "The Python package is not checked: this machine has no Python."
  python_sh test target/debug/riverseed
  succeeded
  said "The Python package is not tested: this machine has no Python."
}

@test "with an old Python it is left out, with a word" {
  put_python 1
  python_sh check
  succeeded
  said "The Python package is not checked: this machine's Python is older than 3.10."
}

@test "where its packages cannot be had it is left out, with a word, and asked for again the next time" {
  put_python 0
  for _ in 1 2; do
    python_sh check
    succeeded
    said "No matching distribution found"
    said "The Python package is not checked: what that needs cannot be had from PyPI."
  done
}

@test "without a command that it knows, it tells them" {
  python_sh chekc
  ((status == 2))
  said "scripts/python.sh check"
  said "scripts/python.sh test"
}
