# scripts/notebooks.sh: when the Python package is not tried in notebooks.

load machine
setup() {
  new_machine
  variables=(HEADLESS_SHELL=chromium)
  mkdir -p "$checkout/python" "$checkout/www/dist-widget"
  echo "jupyterlab==4.6.6" >"$checkout/python/requirements-notebooks.txt"
  echo "maturin==1.16.0" >"$checkout/python/requirements.txt"
  touch "$checkout/www/dist-widget/river-seed.classic.js"
}

notebooks() { run on_machine "$checkout/scripts/notebooks.sh"; }

# left_out WHY
left_out() {
  succeeded
  said "The Python package is not tested in notebooks: $1."
}

# put_python VERSION-SWITCH PIP: what `python3 -c` answers, 0 for a Python that is new enough. Its venv has a pip that does PIP.
put_python() {
  cat >"$usr/bin/python3" <<END
#!/bin/sh
case "\$1 \$2" in
  "-m venv")
    mkdir -p "\$3/bin"
    for name in python maturin; do printf '#!/bin/sh\n' >"\$3/bin/\$name"; done
    printf '#!/bin/sh\n%s\n' '$2' >"\$3/bin/pip"
    chmod +x "\$3/bin/"* ;;
  *) exit $1 ;;
esac
END
  chmod +x "$usr/bin/python3"
}

@test "without Python it is left out, with a word" {
  notebooks
  left_out "this machine has no Python"
}

@test "with a Python that the packages do not run on it is left out, with a word" {
  put_python 1 ""
  notebooks
  left_out "this machine's Python is older than 3.11"
}

@test "without the element or a browser it is left out, with a word" {
  put_python 0 ""
  rm "$checkout/www/dist-widget/river-seed.classic.js"
  notebooks
  left_out "the element is not built (make widget)"
  touch "$checkout/www/dist-widget/river-seed.classic.js"
  variables=()
  notebooks
  left_out "this machine has no Chromium"
}

@test "where its packages cannot be had it is left out, with a word" {
  put_python 0 "exit 1"
  notebooks
  left_out "JupyterLab, marimo or what goes with them cannot be had from PyPI"
}

@test "where no wheel can be built it is left out, with a word" {
  put_python 0 'case "$*" in *requirements.txt*) exit 1 ;; esac'
  notebooks
  said "The Python package is not built: what that needs cannot be had from PyPI."
  left_out "there is no wheel"
}
