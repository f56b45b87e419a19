/** Finished rivers as the files that widgets make, too: pictures and shapes. */

import type { Size } from "../browser/canvas.ts";
import type { FullRiver } from "../engine/full.ts";
import type { River } from "../engine/types.ts";
import { Blitter } from "../player/blit.ts";
import { askChartForFile, type FileMeans } from "../player/chart-maker.ts";
import { type Canvas, contextOf } from "../player/river-player.ts";

/** Pixels on the long side of a PNG: a full page in print, and on any screen more than there is. */
export const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

/** What pictures are taken out of, and what their files take. */
export interface Painting extends FileMeans {
  readonly memory: WebAssembly.Memory;
}

/** Its picture, `longSide` pixels on the long side. */
export async function pngOf(river: River, core: Painting, longSide: number): Promise<Blob> {
  return encoded(await finished(river, () => drawn(river, core, longSide)));
}

/** Its shapes. */
export function svgOf(river: FullRiver, core: FileMeans): Promise<Blob> {
  return finished(river, async () => {
    const chart = river.wantsChart() ? await askChartForFile(river, core, (chart) => chart.svg()) : [];
    core.holdOn();
    return new Blob([river.svg(chart)], { type: "image/svg+xml" });
  });
}

/** Makes something of a river when it has come to its end. */
export async function finished<Made>(river: River, make: () => Made | Promise<Made>): Promise<Made> {
  try {
    await inSlices(() => river.advance(1));
    return await make();
  } finally {
    river.free();
  }
}

/** Takes steps, each of which says whether there are more, and lets the page answer in between. */
export async function inSlices(step: () => boolean): Promise<void> {
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

/** Painted for the file rather than enlarged from the screen. */
export async function drawn(river: River, core: Painting, longSide: number): Promise<Canvas> {
  const { width, height } = sizeFor(river.aspect, longSide);
  river.resize(width, height);
  if (river.wantsChart()) {
    river.takeChart(await askChartForFile(river, core, (chart) => chart.masks(width, height, 1, new Float32Array())));
  }
  core.holdOn();
  while (river.paint());
  const canvas = bareCanvas(width, height);
  new Blitter(contextOf(canvas), core.memory).blit(river);
  return canvas;
}

/** A canvas of no page, where there is such a thing: a worker has no other. */
function bareCanvas(width: number, height: number): Canvas {
  if ("OffscreenCanvas" in globalThis) return new OffscreenCanvas(width, height);
  // biome-ignore lint/style/noRestrictedGlobals: a worker does not come here
  return Object.assign(document.createElement("canvas"), { width, height });
}

export function encoded(canvas: Canvas): Promise<Blob> {
  if ("convertToBlob" in canvas) return canvas.convertToBlob({ type: "image/png" });
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

function sizeFor(aspect: number, longSide: number): Size {
  const shrink = longSide / Math.max(aspect, 1);
  return { width: Math.max(1, Math.round(aspect * shrink)), height: Math.max(1, Math.round(shrink)) };
}
