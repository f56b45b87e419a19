// Draws maps for the built site, in a thread of its own (build/gallery/drawing.ts): takes a link and the pictures that are wanted of
// it, grows its rivers once and gives the files back.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { parentPort } from "node:worker_threads";
import * as fontkit from "fontkit";
import sharp from "sharp";
import { initSync, River } from "../pkg-engine/riverseed_engine.js";

const wasm = new URL("../pkg-engine/riverseed_engine_bg.wasm", import.meta.url);
const { memory } = initSync({ module: readFileSync(wasm) });
// Threads by themselves are as many as there are cores.
sharp.concurrency(1);

const FONT = fontkit.openSync(
  fileURLToPath(
    new URL("../node_modules/@fontsource/eb-garamond/files/eb-garamond-latin-400-normal.woff2", import.meta.url),
  ),
);

/** Left and lower margin of a title, and its letters' size, in pixels. */
const TITLE = { left: 44, below: 38, size: 56 };
/** What is written on dark ground and on light, and what lies around the letters. */
const ON_DARK = { ink: "#e6efe9", halo: "#09131a" };
const ON_LIGHT = { ink: "#22333b", halo: "#f3ecd6" };

parentPort?.on("message", async ({ link, shots }) => {
  try {
    parentPort?.postMessage({ files: await filesOf(link, shots) });
  } catch (error) {
    parentPort?.postMessage({ error: `${link}: ${error instanceof Error ? error.message : error}` });
  }
});

async function filesOf(link, shots) {
  const river = new River(link);
  try {
    while (river.advance(1000));
    const files = [];
    for (const shot of shots) files.push(await encoded(painted(river, shot), shot));
    return files;
  } finally {
    river.free();
  }
}

/** RGBA, row by row. */
function painted(river, { width, height, framing = [], ratio = 1 }) {
  river.resize(width, height, ratio);
  river.frame(framing);
  while (river.paint());
  return new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
}

async function encoded(pixels, { width, height, format, quality, title }) {
  const picture = sharp(pixels, { raw: { width, height, channels: 4 } }).removeAlpha();
  if (title !== undefined) picture.composite([{ input: Buffer.from(titled(title, { width, height }, pixels)) }]);
  const isLossy = { quality, effort: 5 };
  return await (format === "webp" ? picture.webp(isLossy) : picture.jpeg({ quality, mozjpeg: true })).toBuffer();
}

/** A title in the lower left corner, as outlines, since no system need have the font. */
function titled(title, { width, height }, pixels) {
  const { ink, halo } = isDarkAt(pixels, width, height) ? ON_DARK : ON_LIGHT;
  const scale = TITLE.size / FONT.unitsPerEm;
  const { glyphs, positions } = FONT.layout(title);
  let x = 0;
  const letters = glyphs.map((glyph, i) => {
    const at = x + (positions[i]?.xOffset ?? 0);
    x += positions[i]?.xAdvance ?? 0;
    return `<path transform="translate(${at} 0)" d="${glyph.path.toSVG()}"/>`;
  });
  const place = `translate(${TITLE.left} ${height - TITLE.below}) scale(${scale} ${-scale})`;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}">
    <g transform="${place}" fill="${ink}" stroke="${halo}" stroke-opacity="0.8" stroke-width="130" stroke-linejoin="round" paint-order="stroke">
    ${letters.join("")}</g></svg>`;
}

/** Whether it is dark, taken all together, where titles stand. */
function isDarkAt(pixels, width, height) {
  let sum = 0;
  let count = 0;
  for (let y = height - TITLE.below - TITLE.size; y < height - TITLE.below; y += 4)
    for (let x = TITLE.left; x < TITLE.left + 4 * TITLE.size; x += 4, count++) {
      const at = (y * width + x) * 4;
      sum += (pixels[at] + pixels[at + 1] + pixels[at + 2]) / 3;
    }
  return sum / count < 128;
}
