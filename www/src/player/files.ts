/** Finished rivers as files. */

import type { Size } from "../browser/canvas.ts";
import type { FilesRiver } from "../engine/files.ts";
import type { River } from "../engine/types.ts";
import { Blitter } from "./blit.ts";
import { type Canvas, contextOf } from "./river-player.ts";

/** Pixels on the long side of a page's PNG: a full page in print, and on any screen more than there is. */
export const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

const WRITTEN = {
  svg: svgOf,
  geojson: (river: FilesRiver) => finished(river, () => text(river.geojson(), "application/geo+json")),
  json: (river: FilesRiver) => finished(river, () => text(river.network(), "application/json")),
};

/** The formats that are written rather than painted. */
export type WrittenFormat = keyof typeof WRITTEN;

/** All formats, each named as its files end. */
export type Format = "png" | WrittenFormat;

export function isFormat(name: string | undefined): name is Format {
  return name === "png" || (name !== undefined && Object.hasOwn(WRITTEN, name));
}

/** Takes a river, which nobody else has, to its end and writes a file of it. It is gone afterwards. */
export function written(river: FilesRiver, format: WrittenFormat): Promise<Blob> {
  return WRITTEN[format](river);
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
export function svgOf(river: FilesRiver): Promise<Blob> {
  return finished(river, () => new Blob([river.svg()], { type: "image/svg+xml" }));
}

/** Makes something of a river when it has come to its end. */
async function finished<Made>(river: River, make: () => Made): Promise<Made> {
  try {
    while (advanceFor(river, SLICE_MS)) await new Promise((resume) => setTimeout(resume));
    return make();
  } finally {
    river.free();
  }
}

/** Returns whether there is more to do. */
function advanceFor(river: River, milliseconds: number): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (!river.advance(1)) return false;
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
