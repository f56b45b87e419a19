#!/usr/bin/env bash
# geotiff.js writes signed heights of 16 and 32 bits as files that say so and hold other numbers; no reader can tell.
#
# Version:  geotiff 3.0.5 from npm, Node.js 20.
# Input:    heights from -500 up as each of the eight kinds of typed array, with a width and a height.
# Guess:    what is written is read again, whatever the kind, as unsigned ones and floats are.
# Seen:     Int16Array (the usual form of terrain) and Int32Array come back as other numbers: -500 as 3138. The file is long enough and says
#           16 or 32 bits, signed, but the writer knows no such arrays: it stores the low byte of each number, side by side, and leaves the
#           rest empty. So two neighbours, 0x0C and 0x42, become 0x0C42 = 3138. GDAL reads the same numbers. Nothing is thrown.
#           And whatever the kind, a file for which no projection was given says EPSG:4326, degrees on Earth.
# So:       write heights with it as floats, or as unsigned numbers with an offset, and name the projection.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund geotiff@3.0.5
cat > write.mjs <<'JAVASCRIPT'
import { fromArrayBuffer, writeArrayBuffer } from "geotiff";

const [width, height] = [8, 4];
const wrong = [];
for (const Kind of [Int8Array, Int16Array, Int32Array, Uint8Array, Uint16Array, Uint32Array, Float32Array, Float64Array]) {
  const [first, step] = Kind.name.startsWith("U") ? [0, 3] : Kind === Int8Array ? [-50, 3] : [-500, 310];
  const heights = Kind.from({ length: width * height }, (_, i) => first + step * i);
  const image = await (await fromArrayBuffer(await writeArrayBuffer(heights, { width, height }))).getImage();
  const [read] = await image.readRasters();
  const isSame = read instanceof Kind && read.every((value, i) => value === heights[i]);
  const { GeographicTypeGeoKey: projection } = image.getGeoKeys();
  console.log(Kind.name, isSame ? "is read as written" : `${heights.slice(0, 3)} … are read as ${read.slice(0, 3)} …`, `in EPSG:${projection}`);
  if (!isSame) wrong.push(Kind.name, read[0]);
  if (projection !== 4326) throw new Error("this has changed: the projection");
}
if (wrong.join() !== "Int16Array,3138,Int32Array,205682862") throw new Error("this has changed");
JAVASCRIPT
node write.mjs
