#!/usr/bin/env bash
# Builds the examples of integrations/ with their generators and opens them in a browser (integrations/tests), in target/integrations. It
# is skipped, with a word, where the generators' npm packages cannot be had, and each generator that is not there by itself.
#
#   scripts/integrations.sh test target/debug/riverseed [TEST…]   the command line, beside the npm package in target/package
#   scripts/integrations.sh wordpress                             packs the WordPress plugin into target/package
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh

workshop=target/integrations

skip() {
  echo "The integrations are not tested: $1."
  exit 0
}

# The packages of integrations/package-lock.json, kept until that changes.
get_packages() {
  mkdir -p "$workshop"
  cmp --silent integrations/package-lock.json "$workshop/installed.json" && return
  rm -rf "$workshop/node_modules"
  cp integrations/package.json integrations/package-lock.json integrations/.npmrc "$workshop"
  npm --prefix "$workshop" ci --no-audit --no-fund --loglevel=error || skip "the generators' packages cannot be had from npm"
  cp integrations/package-lock.json "$workshop/installed.json"
}

# The npm package of this checkout, as if npm had installed it.
unpack_element() {
  local package=$workshop/node_modules/riverseed tarballs
  tarballs=(target/package/riverseed-*.tgz)
  [[ -e ${tarballs[0]} ]] || { echo "target/package has no npm package: run make tarball" >&2; exit 1; }
  rm -rf "$package"
  mkdir -p "$package"
  tar -xzf "${tarballs[0]}" -C "$package" --strip-components 1
}

case ${1-} in
  test)
    get_packages
    unpack_element
    RIVERSEED_PROGRAM=$(realpath "$2")
    RIVERSEED_WORDPRESS=$RIVERSEED_CACHE/wordpress
    export RIVERSEED_PROGRAM RIVERSEED_WORDPRESS
    shift 2
    (($#)) || set -- integrations/tests/*.test.mjs
    # Two files at a time: a generator uses one core most of the time.
    exec node --test --test-concurrency=2 --test-timeout=300000 --test-reporter=spec "$@"
    ;;
  wordpress)
    # Who asks for a plugin is not helped without one.
    skip() { echo "The WordPress plugin is not packed: $1." >&2; exit 1; }
    get_packages
    unpack_element
    mkdir -p "$workshop/wordpress"
    cp -R integrations/wordpress/. "$workshop/wordpress"
    cp integrations/river-seed.mjs "$workshop"
    node "$workshop/wordpress/pack.mjs" "$workshop/node_modules/riverseed" target/package/river-seed-wordpress.zip
    ;;
  *) sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
