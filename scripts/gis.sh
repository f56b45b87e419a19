#!/usr/bin/env bash
# Runs tests/gis.mjs on a riverseed program; skips it, with a word, where GDAL cannot be had.
#
#   scripts/gis.sh target/debug/riverseed
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/env.sh
source scripts/lib/apt.sh

say() { printf '\033[1mgis:\033[0m %s\n' "$*"; }
skip() {
  echo "The test with a geographic information system is skipped: $1."
  exit 0
}
has_gdal() { have gdalinfo && have ogrinfo && have ogr2ogr && have gdal_translate; }

has_gdal || apt_get "GDAL, half a minute" gdal-bin || true
has_gdal || skip "this machine has no GDAL"
have node || skip "this machine has no Node.js"
node tests/gis.mjs "$1"
