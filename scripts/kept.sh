#!/usr/bin/env bash
# Keeps what cargo compiled of other people's crates in the tools' cache, from one clone to the next: they are the same for the same lock
# file, profile, flags and compilers. What is ours is never kept.
#
#   scripts/kept.sh take    puts what is kept into target, where there is no target yet
#   scripts/kept.sh keep    keeps what is in target, unless it is kept already
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

folders=(debug wasm/debug wasm/release wasm/wasm32-unknown-unknown/debug wasm/wasm32-unknown-unknown/release python/debug)

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
  cargo metadata --quiet --no-deps --format-version 1 |
    node -e 'const { packages } = JSON.parse(require("fs").readFileSync(0)); const names = packages.flatMap((one) => [one.name, ...one.targets.map((target) => target.name)]);
      console.log([...new Set(names.flatMap((name) => [name, name.replaceAll("-", "_")]))].join("\n"))'
  printf '%s\n' riverseed-python riverseed_python riverseed-fuzz riverseed_fuzz _native
}

# copy FROM TO: what cargo made of other people's crates in a folder.
copy() {
  local part entry name
  for part in .fingerprint build deps; do
    [[ -d $1/$part ]] || continue
    mkdir -p "$2/$part"
    for entry in "$1/$part"/*; do
      name=${entry##*/}
      name=${name#lib}
      grep --quiet --line-regexp --fixed-strings -- "${name%-*}" <<<"$own" || printf '%s\0' "$entry"
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
  local folder own new
  own=$(own_names)
  mkdir -p "$RIVERSEED_CACHE/crates"
  new=$(mktemp -d "$RIVERSEED_CACHE/crates/new.XXXXXX")
  for folder in "${folders[@]}"; do copy "target/$folder" "$new/$folder"; done
  find "$RIVERSEED_CACHE/crates" -mindepth 1 -maxdepth 1 ! -path "$new" -exec rm -rf {} +
  mv "$new" "$kept"
}

kept=$RIVERSEED_CACHE/crates/$(digest)
case ${1-} in
  take | keep) "$1" ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
