/** Makes the files of finished rivers that widgets can make, too: pictures and shapes. */

import type { River } from "../engine/types.ts";
import type { WholeRiver } from "../engine/whole.ts";
import type { Course } from "./course.ts";
import { riverPng } from "./river-png.ts";

/** Pixels on the long side of a game pack's picture: a full page in print, and more than any screen has. */
export const LONG_SIDE_PX = 3000;
/** The time for growing at once, short so that the page keeps answering. */
const SLICE_MS = 12;

/** The means of making a file, besides its river. */
export interface FileMeans {
  /** Called before a long step: a file is painted or written in one. */
  holdOn(): void;
}

/** The means of painting a file: the memory that holds the picture, and those of every file. */
export interface Painting extends FileMeans {
  readonly memory: WebAssembly.Memory;
}

/** Grows a river to its end and makes a PNG of it, `longSide` pixels on the long side. */
export function pngOf(river: River, core: Painting, longSide: number): Promise<Blob> {
  return finished(river, () => picture(river, core, longSide));
}

/** Grows a river to its end and makes an SVG of it. */
export function svgOf(river: WholeRiver, { holdOn }: FileMeans): Promise<Blob> {
  return finished(river, () => {
    holdOn();
    return new Blob([river.svg()], { type: "image/svg+xml" });
  });
}

/** Grows a river to its end, makes something of it, and frees it. */
export async function finished<Made>(river: River, make: () => Made | Promise<Made>): Promise<Made> {
  try {
    await inSlices(() => river.advance(1));
    return await make();
  } finally {
    river.free();
  }
}

/** Takes steps until one returns false, and lets the page answer in between. */
export async function inSlices(step: () => boolean): Promise<void> {
  while (stepsFor(SLICE_MS, step)) await new Promise((resume) => setTimeout(resume));
}

/** Takes steps for some time. Returns whether there is more to do. */
function stepsFor(milliseconds: number, step: () => boolean): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (!step()) return false;
  } while (performance.now() < end);
  return true;
}

/** Paints a finished river for a file, rather than enlarging it from the screen, and writes that as PNG. */
export function picture(river: River, core: Painting, longSide: number): Promise<Blob> {
  const [width = 1, height = 1] = river.sidesFor(Math.max(1, Math.round(longSide)));
  river.resize(width, height);
  core.holdOn();
  while (river.paint());
  return riverPng(river, core.memory, "rgb", SILENT);
}

/** A course that reports no progress, and lets others have their turn. */
export const SILENT: Course = { tell: () => {}, pause: () => new Promise((resume) => setTimeout(resume)) };
