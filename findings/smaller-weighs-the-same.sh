#!/usr/bin/env bash
# What wasm-opt saves on a module for the web is gone after compression; what it adds to make it fast is not.
#
# Versions: wasm-opt of binaryen 132.0.0 from npm, on the module of @resvg/resvg-wasm 2.6.2 (a painter of SVG made from Rust, optimised once by
#           its authors); brotli of Node.js 20 at its highest level.
# Guess:    -Oz saves a twentieth of what is sent, and --converge, which repeats all passes until nothing changes, another hundredth of it.
# Seen:     bytes               bare    brotli
#           as published     2478606    692224
#           -Oz              2426035    693899   2 % smaller, and 0.2 % heavier to send (written again without a pass: 694192)
#           -O3              2481593    696416
#           -O3 --converge   2481142    695589   0.1 % lighter, for twice the time
#           What -Oz removes are repetitions, which a compressor had for nothing.
# So:       judge flags by what is sent, and choose those that run fastest. Weight goes with code that is not there, not with code written shorter.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund binaryen@132.0.0 @resvg/resvg-wasm@2.6.2
module=node_modules/@resvg/resvg-wasm/index_bg.wasm
for flags in -Oz -O3; do
  node_modules/.bin/wasm-opt --all-features "$flags" "$module" -o "made$flags.wasm"
done
cat > weigh.mjs <<'JAVASCRIPT'
import { readFileSync } from "node:fs";
import { brotliCompressSync } from "node:zlib";

const [published, small, fast] = process.argv.slice(2).map((file) => {
  const bytes = readFileSync(file);
  const weight = { bare: bytes.length, brotli: brotliCompressSync(bytes).length };
  console.log(file, weight);
  return weight;
});
const isSmaller = small.bare < 0.985 * published.bare;
const isNoLighter = small.brotli > 0.998 * published.brotli && fast.brotli < 1.01 * small.brotli;
if (!isSmaller || !isNoLighter) throw new Error("this has changed");
JAVASCRIPT
node weigh.mjs "$module" made-Oz.wasm made-O3.wasm
