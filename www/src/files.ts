/** The finished rivers of a link as files. */

import type { River } from "../pkg/riverseed.js";
import { Blitter } from "./blit.ts";
import type { Size } from "./canvas.ts";
import { el } from "./dom.ts";
import type { Core } from "./wasm.ts";

/** Pixels on the long side of a PNG: a full page in print, and on any screen more than there is. */
const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

const FORMATS = {
  png: (core: Core, river: River) => png(core, river),
  svg: (_core: Core, river: River) => new Blob([river.svg()], { type: "image/svg+xml" }),
  geojson: (_core: Core, river: River) => text(river.geojson(), "application/geo+json"),
  json: (_core: Core, river: River) => text(river.network(), "application/json"),
};

/** The formats, each named as its files end. */
export type Format = keyof typeof FORMATS;

export function isFormat(name: string | undefined): name is Format {
  return name !== undefined && Object.hasOwn(FORMATS, name);
}

/** Grows a river of its own to its end and makes a file of it: what the page shows need not be finished. */
export async function fileOf(core: Core, link: string, format: Format): Promise<Blob> {
  const river = new core.engine.River(link, 16, 16);
  try {
    while (!advanceFor(river, SLICE_MS)) await new Promise((resume) => setTimeout(resume));
    return await FORMATS[format](core, river);
  } finally {
    river.free();
  }
}

function advanceFor(river: River, milliseconds: number): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (river.advance(1)) return true;
  } while (performance.now() < end);
  return false;
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}

/** Drawn for the file rather than enlarged from the screen. */
function png(core: Core, river: River): Promise<Blob> {
  const { width, height } = sizeFor(river.aspect);
  river.resize(width, height);
  river.paint();
  const canvas = el("canvas", { width, height });
  const context = canvas.getContext("2d", { alpha: false });
  if (!context) throw new Error("this browser gives no 2D canvas");
  new Blitter(context, core.memory).blit(river);
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

function sizeFor(aspect: number): Size {
  const shrink = LONG_SIDE_PX / Math.max(aspect, 1);
  return { width: Math.round(aspect * shrink), height: Math.round(shrink) };
}
