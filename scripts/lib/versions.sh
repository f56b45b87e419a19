# Versions: asked of programs, read from files, compared.
# shellcheck shell=bash

have() { command -v "$1" >/dev/null; }

# Whether version $1 is at least version $2. No version at all is not.
at_least() { [[ -n $1 && $(printf '%s\n' "$1" "$2" | sort -V | head -n 1) == "$2" ]]; }

# The version that a program says it has; nothing if it is not there or does not run. Some that cargo starts have to be
# asked as cargo asks them.
version_of() {
  { "$1" --version || { [[ $1 == cargo-* ]] && "$1" "${1#cargo-}" --version; } || true; } 2>/dev/null |
    sed -n 's/^[^0-9]*\([0-9][0-9]*\.[0-9][0-9.]*\).*/\1/p' | head -n 1
}

# The first text in file $2 that looks like `$1 = "…"`.
value_of() { sed -n "s/^$1 *= *\"\([^\"]*\)\".*/\1/p" "$2" | head -n 1; }

# The version of a Debian package that is installed; nothing if it is not, or only its settings are left.
package_version() {
  local found
  # shellcheck disable=SC2016  # dpkg-query expands these
  found=$(dpkg-query --show --showformat='${db:Status-Abbrev}${Version}' "$1" 2>/dev/null) || return 0
  [[ $found != ?i* ]] || echo "${found:3}"
}
