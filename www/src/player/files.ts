/** Finished rivers as files. */

import type { Size } from "../browser/canvas.ts";
import type { FullCore, FullRiver } from "../engine/full.ts";
import type { River } from "../engine/types.ts";
import { Blitter } from "./blit.ts";
import { contentsOf, packed } from "./game-pack.ts";
import { type Canvas, contextOf } from "./river-player.ts";

/** Pixels on the long side of a PNG: a full page in print, and on any screen more than there is. */
const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

const FORMATS = {
  png: (river: FullRiver, { memory }: FullCore) => pngOf(river, memory, LONG_SIDE_PX),
  svg: svgOf,
  geojson: (river: FullRiver) => raised(river, () => text(river.geojson(), "application/geo+json")),
  json: (river: FullRiver) => finished(river, () => text(river.network(), "application/json")),
  zip: packOf,
};

/** The formats, each named as its files end. */
export type Format = keyof typeof FORMATS;

export function isFormat(name: string | undefined): name is Format {
  return name !== undefined && Object.hasOwn(FORMATS, name);
}

/** Takes a river, which nobody else has, to its end and makes a file of it. It is gone afterwards. */
export function fileOf(river: FullRiver, core: FullCore, format: Format): Promise<Blob> {
  return FORMATS[format](river, core);
}

/** Its picture, `size` pixels on the long side. Reports when it begins to paint, which is one step. */
export async function pngOf(
  river: River,
  memory: WebAssembly.Memory,
  longSide: number,
  painting: () => void = () => {},
): Promise<Blob> {
  const canvas = await finished(river, () => {
    painting();
    return drawn(river, memory, longSide);
  });
  return encoded(canvas);
}

/** Its shapes. */
export function svgOf(river: FullRiver): Promise<Blob> {
  return finished(river, () => new Blob([river.svg()], { type: "image/svg+xml" }));
}

/** All that games need, and the picture. */
async function packOf(river: FullRiver, { memory }: FullCore): Promise<Blob> {
  const [contents, canvas] = await raised(
    river,
    () => [contentsOf(river), drawn(river, memory, LONG_SIDE_PX)] as const,
  );
  return packed(contents, await (await encoded(canvas)).arrayBuffer());
}

/** Makes something of a river and its relief, in a style that shows none too. */
function raised<Made>(river: FullRiver, make: () => Made | Promise<Made>): Promise<Made> {
  return finished(river, async () => {
    await inSlices(() => river.raiseRelief());
    return make();
  });
}

/** Makes something of a river when it has come to its end. */
async function finished<Made>(river: River, make: () => Made | Promise<Made>): Promise<Made> {
  try {
    await inSlices(() => river.advance(1));
    return await make();
  } finally {
    river.free();
  }
}

/** Takes steps, each of which says whether there are more, and lets the page answer in between. */
async function inSlices(step: () => boolean): Promise<void> {
  while (stepsFor(SLICE_MS, step)) await new Promise((resume) => setTimeout(resume));
}

/** Returns whether there is more to do. */
function stepsFor(milliseconds: number, step: () => boolean): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (!step()) return false;
  } while (performance.now() < end);
  return true;
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}

/** Painted for the file rather than enlarged from the screen. */
function drawn(river: River, memory: WebAssembly.Memory, longSide: number): Canvas {
  const { width, height } = sizeFor(river.aspect, longSide);
  river.resize(width, height);
  river.paint();
  const canvas = bareCanvas(width, height);
  new Blitter(contextOf(canvas), memory).blit(river);
  return canvas;
}

/** A canvas of no page, where there is such a thing: a worker has no other. */
function bareCanvas(width: number, height: number): Canvas {
  if ("OffscreenCanvas" in globalThis) return new OffscreenCanvas(width, height);
  // biome-ignore lint/style/noRestrictedGlobals: a worker does not come here
  return Object.assign(document.createElement("canvas"), { width, height });
}

function encoded(canvas: Canvas): Promise<Blob> {
  if ("convertToBlob" in canvas) return canvas.convertToBlob({ type: "image/png" });
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

function sizeFor(aspect: number, longSide: number): Size {
  const shrink = longSide / Math.max(aspect, 1);
  return { width: Math.max(1, Math.round(aspect * shrink)), height: Math.max(1, Math.round(shrink)) };
}
