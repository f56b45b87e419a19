#!/usr/bin/env bash
# Keeps what cargo compiled of other people's crates in the tools' cache, from one clone to the next: they are the same for the same lock
# file, profile, flags and compilers. What is ours is never kept.
#
#   scripts/kept.sh take    puts what is kept into target, where there is no target yet
#   scripts/kept.sh keep    keeps what is in target, unless it is kept already
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

# Prints the folders of target that crates are compiled in, as far as they are there. Each wasm package has one of its own.
folders() {
  (cd target && shopt -s nullglob && printf '%s\n' debug python/debug wasm/{,wasm32-unknown-unknown/}debug wasm/*/{,wasm32-unknown-unknown/}release)
}

# A name for all that decides how these crates are compiled.
digest() {
  {
    cat Cargo.lock python/Cargo.lock .cargo/config.toml
    sed -n '/^\[profile/,/^$/p' Cargo.toml python/Cargo.toml
    rustc -vV
    (use_wasm_rust && rustc -vV) || true
  } | sha256sum | cut -c 1-20
}

# The names that files of our own crates begin with, as cargo writes them: of packages and of their targets.
own_names() {
  sed -n 's/^name = "\(.*\)"/\1/p' {.,crates/*,python,fuzz}/Cargo.toml 2>/dev/null | sed 'p; s/-/_/g'
  basename --multiple --suffix=.rs examples/*.rs benches/*.rs fuzz/fuzz_targets/*.rs
}

# copy FROM TO: what cargo made of other people's crates in a folder. It calls files by their crate and sixteen digits.
copy() {
  local part entry
  for part in .fingerprint build deps; do
    [[ -d $1/$part ]] || continue
    mkdir -p "$2/$part"
    for entry in "$1/$part"/*; do
      if [[ ${entry##*/} =~ ^(lib)?(.*)-[0-9a-f]{16} && -z ${own[${BASH_REMATCH[2]}]-} ]]; then printf '%s\0' "$entry"; fi
    done | xargs --null --no-run-if-empty cp --archive --target-directory "$2/$part"
  done
}

take() {
  [[ -d $kept && ! -d target/debug ]] || return 0
  echo "Crates that were compiled before are taken from $kept"
  mkdir -p target
  cp --archive "$kept/." target
}

# Only the newest are kept: a lock file changes every few weeks.
keep() {
  [[ ! -d $kept ]] || return 0
  local folder name new
  local -A own=()
  while read -r name; do own[$name]=ours; done < <(own_names)
  mkdir -p "$RIVERSEED_CACHE/crates"
  new=$(mktemp -d "$RIVERSEED_CACHE/crates/new.XXXXXX")
  for folder in $(folders); do copy "target/$folder" "$new/$folder"; done
  find "$RIVERSEED_CACHE/crates" -mindepth 1 -maxdepth 1 ! -path "$new" -exec rm -rf {} +
  mv "$new" "$kept"
}

kept=$RIVERSEED_CACHE/crates/$(digest)
case ${1-} in
  take | keep) "$1" ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
