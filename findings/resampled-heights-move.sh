#!/usr/bin/env bash
# Heights that geotiff.js reads at another size lie beside where they were: at a tenth of the size by half a cell of what is read.
#
# Version:  geotiff 3.0.5 from npm, Node.js 20; for comparison GDAL 3.10.3 by rasterio 1.4.4.
# Input:    a slope of 100 by 100 cells, each as high as its column, read at 50, 10 and 200 columns with `resampleMethod: "bilinear"`.
# Guess:    a cell read has the height of the place where its middle lies, as with GDAL: at 10 columns 14.5, 24.5 … (less at the border).
# Seen:     0, 10, 20 … at 10 columns, and 0, 2, 4 … at 50: positions are scaled about the middle of the first cell, not about its corner. At
#           10 columns all lies 4.5 cells of the file too far east and south. No heights are mixed where the picture becomes smaller by a whole
#           factor: bilinear gives what nearest gives. At 200 columns the slope begins with 0, 0.5, 1 where 0, 0.25, 0.75 is right, and its end is
#           flat.
# So:       read at full size and resample yourself, or rivers and the heights under them part.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund geotiff@3.0.5
cat > read.mjs <<'JAVASCRIPT'
import { fromArrayBuffer, writeArrayBuffer } from "geotiff";

const side = 100;
const slope = Float32Array.from({ length: side * side }, (_, i) => i % side);
const image = await (await fromArrayBuffer(await writeArrayBuffer(slope, { width: side, height: side }))).getImage();
const seen = [];
for (const size of [50, 10, 200]) {
  const [heights] = await image.readRasters({ width: size, height: size, resampleMethod: "bilinear" });
  const middles = [0, 1, 2].map((i) => Math.max(0, ((i + 0.5) * side) / size - 0.5));
  console.log(`${size} columns: ${heights.slice(0, 3)} … ${heights.slice(size - 2, size)}; heights at the middles: ${middles} …`);
  seen.push(...heights.slice(0, 3));
}
if (seen.join() !== "0,2,4,0,10,20,0,0.5,1") throw new Error("this has changed");
JAVASCRIPT
node read.mjs
