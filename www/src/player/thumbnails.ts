/** Small pictures of finished maps, made a little at a time: of one map in many styles, or of another map. */

import { named } from "../engine/errors.ts";
import { isEngineUnsure } from "../engine/unsure.ts";
import type { WholeRiver } from "../engine/whole.ts";

/** The time for making them in one task. */
const BUDGET_MS = 8;

export interface Picture {
  width: number;
  height: number;
  /** RGBA, row by row. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
}

export interface Thumbnail extends Picture {
  style: string;
}

type Pause = () => Promise<boolean>;

/**
 * Makes a thumbnail in each style of a river, which it takes over and frees. `pause` is called between tasks and
 * returns whether to go on. A style that fails, for lack of memory for example, is left out, unless the engine has
 * stopped.
 */
export async function* thumbnails(
  river: WholeRiver,
  memory: WebAssembly.Memory,
  styles: readonly string[],
  { width, height }: { width: number; height: number },
  pause: Pause,
): AsyncGenerator<Thumbnail> {
  let mayFree = true;
  try {
    river.resize(width, height);
    for (const style of styles) {
      if (!(await pause())) return;
      const pixels = await pixelsIn(style, river, memory, pause).catch((thrown: unknown) => {
        mayFree = !isEngineUnsure(named(thrown));
        if (!mayFree) throw thrown;
      });
      if (pixels === "stopped") return;
      if (pixels) yield { style, width, height, pixels };
    }
  } finally {
    if (mayFree) river.free();
  }
}

/**
 * Makes a picture of a river's finished map, without letters and scenery. It takes the river over and frees it. Returns
 * nothing if `pause` stopped it before.
 */
export async function finishedPicture(
  river: WholeRiver,
  memory: WebAssembly.Memory,
  { width, height }: { width: number; height: number },
  pause: Pause,
): Promise<Picture | undefined> {
  let mayFree = true;
  try {
    river.resize(width, height);
    const pixels = await pixelsOf(river, memory, pause);
    return pixels === "stopped" ? undefined : { width, height, pixels };
  } catch (thrown) {
    mayFree = !isEngineUnsure(named(thrown));
    throw thrown;
  } finally {
    if (mayFree) river.free();
  }
}

async function pixelsIn(
  style: string,
  river: WholeRiver,
  memory: WebAssembly.Memory,
  pause: Pause,
): Promise<Picture["pixels"] | "stopped"> {
  river.change(inStyle(river.link, style));
  return pixelsOf(river, memory, pause);
}

async function pixelsOf(
  river: WholeRiver,
  memory: WebAssembly.Memory,
  pause: Pause,
): Promise<Picture["pixels"] | "stopped"> {
  if (!(await inSlices(() => river.advance(1), pause))) return "stopped";
  if (!(await inSlices(() => river.paint(), pause))) return "stopped";
  return new Uint8ClampedArray(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
}

/** Returns a link with another style, and without labels and scenery, which would be too small to see. */
export function inStyle(link: string, style: string): string {
  const values = new URLSearchParams(link);
  values.set("style", style);
  for (const key of ["labels", "cartouche"]) values.set(key, "none");
  // What is left out, its country may have.
  for (const key of ["woods", "hills"]) values.set(key, "0");
  return values.toString();
}

/** Repeats a step until there is no more to do. Returns false if `pause` stopped it before. */
async function inSlices(step: () => boolean, pause: Pause): Promise<boolean> {
  let end = performance.now() + BUDGET_MS;
  while (step()) {
    if (performance.now() < end) continue;
    if (!(await pause())) return false;
    end = performance.now() + BUDGET_MS;
  }
  return true;
}
