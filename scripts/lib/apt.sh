# Packages of the system, where it has apt. Its lists can be months old: what it offers is looked at before anything is
# installed, and they are refreshed, once, if that is too old or not there.
# shellcheck shell=bash

apt_log=target/apt.log
lists_are_fresh=

as_root() { if ((EUID == 0)); then "$@"; else sudo "$@"; fi; }

# apt_get "WHAT FOR, HOW LONG" PACKAGE…   False when it cannot be done. A package may be `name>=version`.
apt_get() {
  if ! have apt-get || ! have apt-cache; then return 1; fi
  offers "${@:2}" || { refresh_lists && offers "${@:2}"; } || { tell_offers "${@:2}"; return 1; }
  say "installing ${*:2} ($1)"
  # What apt offers may be gone from the archive, when its lists are old.
  apt_install "${@:2}" || { refresh_lists && apt_install "${@:2}"; } || { tail -n 3 $apt_log >&2; return 1; }
}

# apt_download "HOW LONG" PACKAGE FOLDER   A package as a file, which is not installed. False when it cannot be done.
apt_download() {
  if ! have apt-get || ! have apt-cache || ! have dpkg-deb; then return 1; fi
  offers "$2" || { refresh_lists && offers "$2"; } || { tell_offers "$2"; return 1; }
  say "downloading $2 ($1)"
  mkdir -p target
  local log=$PWD/$apt_log
  download() { (cd "$2" && apt-get download -qq "$1" >"$log" 2>&1); }
  download "$2" "$3" || { refresh_lists && download "$2" "$3"; } || { tail -n 3 "$log" >&2; return 1; }
}

# Never by removing what somebody else installed.
apt_install() {
  mkdir -p target
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends --no-remove \
    -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 "${@%%>=*}" >$apt_log 2>&1
}

# False when they have been refreshed before.
refresh_lists() {
  [[ -z $lists_are_fresh ]] || return
  lists_are_fresh=yes
  say "refreshing apt's package lists"
  mkdir -p target
  # A failure of one source of several says nothing of the others. But a new machine may be refreshing them itself: five
  # minutes for that.
  local tries=30
  until as_root apt-get update -qq >$apt_log 2>&1 || ! grep -q 'Could not get lock' $apt_log || ((--tries == 0)); do
    sleep 10
  done
}

# The version apt would install; nothing when it has none.
candidate() { LC_ALL=C apt-cache policy "$1" 2>/dev/null | sed -n 's/^ *Candidate: \([0-9]*:\)\{0,1\}\([^(].*\)/\2/p'; }

# What stands behind `name>=`; any version is at least 0.
wanted_version() { [[ $1 != *'>='* ]] && echo 0 || echo "${1#*>=}"; }

# Whether what apt would install of all these packages is new enough.
offers() {
  local package version
  for package; do
    version=$(candidate "${package%%>=*}")
    at_least "$version" "$(wanted_version "$package")" || return 1
  done
}

tell_offers() {
  local package version
  for package; do
    offers "$package" && continue
    version=$(candidate "${package%%>=*}")
    say "apt's archives have ${package%%>=*} ${version:-not at all}, wanted: $package"
  done
}
