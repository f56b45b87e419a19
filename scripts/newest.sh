#!/usr/bin/env bash
# Compares the committed digests with those of the newest versions that Cargo.toml's ranges allow. The library asks for ranges,
# and its users may get newer versions than Cargo.lock has: this tells whether one of them changes a bit. Not part of CI, whose
# outcome must not depend on what was published today.
#
#   scripts/newest.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

# A copy, so that Cargo.lock here stays as it is.
copy=target/newest
rm -rf "$copy"
mkdir -p "$copy"
tar -cf - --exclude=./target --exclude=./www --exclude=./python --exclude=./fuzz --exclude=./.git . | tar -xf - -C "$copy"

export CARGO_TARGET_DIR=$PWD/target/newest-build
cd "$copy"
cargo update --quiet
diff ../../Cargo.lock Cargo.lock | sed -n 's/^> version = /now /p' | sort | uniq -c || true
cargo test --quiet --all-features --test all digest
