# scripts/python.sh: when the Python package is left out.

load machine
setup() {
  new_machine
  mkdir "$checkout/python"
  echo "numpy==2.2.6" >"$checkout/python/requirements.txt"
}

python_sh() { run on_machine "$checkout/scripts/python.sh" "$@"; }

# put_python VERSION-SWITCH [PIP]: what `python3 -c` answers, 0 for a Python that is new enough. Its venv has a pip without any packages,
# or one that does PIP.
put_python() {
  local pip=${2-'echo "No matching distribution found" >&2; exit 1'}
  cat >"$usr/bin/python3" <<EOF
#!/bin/sh
case "\$1 \$2" in
  "-m venv")
    echo "venv \$3" >>"\$machine/calls"
    mkdir -p "\$3/bin"
    for name in python maturin ruff mypy; do
      printf '#!/bin/sh\n' >"\$3/bin/\$name"
    done
    printf '#!/bin/sh\n%s\n' '$pip' >"\$3/bin/pip"
    chmod +x "\$3/bin/"* ;;
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

@test "a wheel that cannot be built is a failure" {
  python_sh wheel
  failed
  said "The Python package is not built: this machine has no Python."
  put_python 0
  python_sh wheel
  failed
  said "The Python package is not built: what that needs cannot be had from PyPI."
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

@test "packages are kept as long as their Python runs" {
  put_python 0 ""
  for _ in 1 2; do
    python_sh check
    succeeded
    called 1 "venv"
  done
  ln -sf "$machine/no/python3" "$checkout/target/python/venv/bin/python"
  for _ in 1 2; do
    python_sh check
    succeeded
    called 2 "venv"
  done
}

@test "a wheel has the element of now, and a word says where it has none" {
  local static=$checkout/python/riverseed/static element=river-seed.classic.js
  put_python 0 ""
  mkdir -p "$static" "$checkout/www/dist-widget"
  echo notices >"$checkout/THIRD-PARTY.txt"
  for said in first second; do
    echo "$said" >"$checkout/www/dist-widget/$element"
    python_sh try
    succeeded
    never_said "has no widget"
    [[ $(cat "$static/$element" "$static/THIRD-PARTY.txt") == "$said"$'\n'notices ]]
  done
  rm "$checkout/www/dist-widget/$element"
  python_sh try
  succeeded
  said "The Python package has no widget: there is no www/dist-widget/$element."
  [[ -z $(ls "$static") ]]
}

@test "without a command that it knows, it tells them" {
  python_sh chekc
  ((status == 2))
  said "scripts/python.sh check"
  said "scripts/python.sh test"
}
