#!/usr/bin/env bash
# Gets what is missing and mends what is broken; leaves alone what serves. A second run takes a few seconds.
#
#   scripts/setup.sh [rust] [lint] [supply] [wasm] [node] [browser] [firefox]      no names: all of these
#   scripts/setup.sh [bindgen] [fuzz] [mutants] [integrations]
#
#   rust      a compiler as new as Cargo.toml asks, and a linker
#   lint      rustfmt and clippy, and shellcheck
#   supply    what reads the licences of the crates: cargo-about and cargo-deny
#   wasm      the wasm32 target, wasm-bindgen (the version in Cargo.lock) and wasm-pack (the one in wasm-pack.toml)
#   bindgen   of these what `make demo` needs: the target and wasm-bindgen
#   node      Node.js, and the packages of www/package-lock.json
#   browser   Chromium and its driver, and Chromium without windows, where apt has it
#   firefox   Firefox, the second engine
#   fuzz      cargo-fuzz, and a C++ compiler
#   mutants   cargo-mutants
#   integrations   Hugo, Jekyll, PHP and Pandoc, where apt has them
#
# System packages are asked of apt, where there is one; all else goes into ~/.cache/riverseed and www/node_modules.
# RIVERSEED_WASM=debian takes the wasm32 target from Debian's packages and never asks rustup for one.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh
source scripts/lib/lock.sh
source scripts/lib/apt.sh
source scripts/parts/rust.sh
source scripts/parts/wasm.sh
source scripts/parts/node.sh
source scripts/parts/browsers.sh
source scripts/parts/supply.sh
source scripts/parts/explore.sh
source scripts/parts/integrations.sh

say() { printf '\033[1msetup:\033[0m %s\n' "$*"; }
die() {
  printf '\033[1msetup:\033[0m %s\n' "$@" >&2
  exit 1
}

main() {
  (($#)) || set -- rust lint supply wasm node browser firefox
  local part
  for part; do
    declare -F "setup_$part" >/dev/null ||
      die "no part is called '$part': rust, lint, supply, wasm, bindgen, node, browser, firefox, fuzz, mutants"
    "setup_$part"
  done
}

take_lock "$RIVERSEED_CACHE/lock" "another set-up"
main "$@" 9>&-
