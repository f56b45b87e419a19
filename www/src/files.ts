/** The finished rivers of a link as files. */

import type { River } from "../pkg/riverseed.js";
import { Blitter } from "./blit.ts";
import type { Size } from "./canvas.ts";
import { el } from "./dom.ts";
import { loadTools, type Tools } from "./tools.ts";
import type { Core } from "./wasm.ts";

/** Pixels on the long side of a PNG: a full page in print, and on any screen more than there is. */
const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

const FORMATS = {
  png: (core: Core, link: string) => finished(core.engine.River, link, (river) => png(core.memory, river)),
  svg: (_core: Core, link: string) => written(link, (river) => new Blob([river.svg()], { type: "image/svg+xml" })),
  geojson: (_core: Core, link: string) => written(link, (river) => text(river.geojson(), "application/geo+json")),
  json: (_core: Core, link: string) => written(link, (river) => text(river.network(), "application/json")),
};

/** The formats, each named as its files end. */
export type Format = keyof typeof FORMATS;

export function isFormat(name: string | undefined): name is Format {
  return name !== undefined && Object.hasOwn(FORMATS, name);
}

/** A river of its own is grown to its end for a file: what the page shows need not be finished. */
export function fileOf(core: Core, link: string, format: Format): Promise<Blob> {
  return FORMATS[format](core, link);
}

/** What is written and not painted takes the tools. */
async function written(link: string, write: (river: InstanceType<Tools["River"]>) => Blob): Promise<Blob> {
  const { River } = await loadTools();
  return finished(River, link, write);
}

/** A river of either module. */
interface Grown {
  advance(steps: number): boolean;
  free(): void;
}

type Planted<River> = new (link: string, width: number, height: number) => River;

/** Makes something of a link's finished river, which is gone afterwards. */
async function finished<River extends Grown, Made>(
  River: Planted<River>,
  link: string,
  make: (river: River) => Made | Promise<Made>,
): Promise<Made> {
  const river = new River(link, 16, 16);
  try {
    while (!advanceFor(river, SLICE_MS)) await new Promise((resume) => setTimeout(resume));
    return await make(river);
  } finally {
    river.free();
  }
}

function advanceFor(river: Grown, milliseconds: number): boolean {
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
function png(memory: WebAssembly.Memory, river: River): Promise<Blob> {
  const { width, height } = sizeFor(river.aspect);
  river.resize(width, height);
  river.paint();
  const canvas = el("canvas", { width, height });
  const context = canvas.getContext("2d", { alpha: false });
  if (!context) throw new Error("this browser gives no 2D canvas");
  new Blitter(context, memory).blit(river);
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

function sizeFor(aspect: number): Size {
  const shrink = LONG_SIDE_PX / Math.max(aspect, 1);
  return { width: Math.round(aspect * shrink), height: Math.round(shrink) };
}
