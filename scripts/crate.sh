#!/usr/bin/env bash
# The crate as it would be published: packed without a warning, small, and with the notices that it must carry.
#
#   scripts/crate.sh pack       only packed
#   scripts/crate.sh verify     also unpacked and checked by itself, as its users have it
#   scripts/crate.sh publish    everything but the upload: the registry is asked as well
#
# It ends up in target/package. Uncommitted changes are packed too; `cargo publish` without --dry-run refuses them.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

limit_kb=1058 # of a download: it is to catch pictures and builds, not source

case ${1-} in
  pack | verify) command=(cargo package --offline --no-verify --package riverseed --all-features) ;;
  publish) command=(cargo publish --dry-run --package riverseed --all-features) ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

mkdir -p target
said=target/crate.log
"${command[@]}" --allow-dirty 2>"$said" || { cat "$said" >&2; exit 1; }
if grep '^warning' "$said" | grep -v 'aborting upload due to dry run'; then
  cat "$said" >&2
  exit 1
fi

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
crate=${CARGO_TARGET_DIR:-target}/package/riverseed-$version.crate
bytes=$(wc -c <"$crate")
echo "$crate: $bytes bytes of $((limit_kb * 1000)), $(tar tzf "$crate" | wc -l) files"
((bytes <= limit_kb * 1000)) || { echo "The crate is TOO LARGE: see 'include' in Cargo.toml." >&2; exit 1; }

# Licences of ours and of others ask to be handed on.
for paper in LICENSE-APACHE LICENSE-MIT THIRD-PARTY.txt; do
  tar xzOf "$crate" "riverseed-$version/$paper" 2>/dev/null | cmp -s - $paper ||
    { echo "The crate lacks $paper as it is here: see 'include' in Cargo.toml." >&2; exit 1; }
done

# Whether it compiles is asked, not how fast it is: optimised it has been for the tests.
if [[ $1 == verify ]]; then
  unpacked=target/package/unpacked
  rm -rf "$unpacked"
  mkdir -p "$unpacked"
  tar xzf "$crate" -C "$unpacked" --strip-components 1
  echo '[workspace]' >>"$unpacked/Cargo.toml"
  cargo check --quiet --offline --all-features --manifest-path "$unpacked/Cargo.toml" --target-dir target
fi
