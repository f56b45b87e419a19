/** The finished rivers of a link as files. */

import type { Size } from "../browser/canvas.ts";
import { loadTools, type Tools } from "../engine/tools.ts";
import type { ReadOptions, River } from "../engine/types.ts";
import type { Core } from "../engine/wasm.ts";
import { Blitter } from "./blit.ts";
import { type Canvas, contextOf, type LinkToRead } from "./river-player.ts";

/** Pixels on the long side of a PNG: a full page in print, and on any screen more than there is. */
const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

const FORMATS = {
  png: (core: Core, link: LinkToRead) => pngOf(core, link, LONG_SIDE_PX),
  svg: (_core: Core, link: LinkToRead) => svgOf(link),
  geojson: (_core: Core, link: LinkToRead) => written(link, (river) => text(river.geojson(), "application/geo+json")),
  json: (_core: Core, link: LinkToRead) => written(link, (river) => text(river.network(), "application/json")),
};

/** The formats, each named as its files end. */
export type Format = keyof typeof FORMATS;

export function isFormat(name: string | undefined): name is Format {
  return name !== undefined && Object.hasOwn(FORMATS, name);
}

/** A river of its own is grown to its end for a file: what the page shows need not be finished. */
export function fileOf(core: Core, text: string, format: Format): Promise<Blob> {
  return FORMATS[format](core, { text });
}

/** A picture of a link's finished river, so many pixels on its long side. Tells when it begins to paint, which is one step. */
export function pngOf(core: Core, link: LinkToRead, longSide: number, painting: () => void = () => {}): Promise<Blob> {
  return finished(core.engine.River, link, (river) => {
    painting();
    return png(core.memory, river, longSide);
  });
}

/** The shapes of a link's finished rivers. */
export function svgOf(link: LinkToRead, toolsUrl?: string): Promise<Blob> {
  return written(link, (river) => new Blob([river.svg()], { type: "image/svg+xml" }), toolsUrl);
}

/** What is written and not painted takes the tools. */
async function written(
  link: LinkToRead,
  write: (river: InstanceType<Tools["River"]>) => Blob,
  toolsUrl?: string,
): Promise<Blob> {
  const { River } = await loadTools(toolsUrl);
  return finished(River, link, write);
}

/** A river of either module. */
interface Grown {
  advance(steps: number): boolean;
  free(): void;
}

type Planted<River> = new (text: string, options?: ReadOptions) => River;

/** Makes something of a link's finished river, which is gone afterwards. */
async function finished<River extends Grown, Made>(
  River: Planted<River>,
  { text, options }: LinkToRead,
  make: (river: River) => Made | Promise<Made>,
): Promise<Made> {
  const river = new River(text, options);
  try {
    while (advanceFor(river, SLICE_MS)) await new Promise((resume) => setTimeout(resume));
    return await make(river);
  } finally {
    river.free();
  }
}

/** Returns whether there is more to do. */
function advanceFor(river: Grown, milliseconds: number): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (!river.advance(1)) return false;
  } while (performance.now() < end);
  return true;
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}

/** Drawn for the file rather than enlarged from the screen. */
function png(memory: WebAssembly.Memory, river: River, longSide: number): Promise<Blob> {
  const { width, height } = sizeFor(river.aspect, longSide);
  river.resize(width, height);
  river.paint();
  const canvas = bareCanvas(width, height);
  new Blitter(contextOf(canvas), memory).blit(river);
  return encoded(canvas);
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
