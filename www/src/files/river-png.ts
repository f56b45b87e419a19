/** Writes the picture of a river as PNG: exactly the core's pixels, with the river's link as text. */

import type { River } from "../engine/types.ts";
import type { Course } from "./course.ts";
import { pngOf } from "./png.ts";

/** The keyword of the link in a picture, the same as the command line's. */
const LINK_KEYWORD = "riverseed";

/**
 * Writes a river's painted picture. `pixels` is "rgba" if its background has been cut out; `dpi` is given for pictures
 * that are made for print, since a screen's dots have no size of their own.
 */
export function riverPng(
  river: Pick<River, "width" | "height" | "fileLink" | "pixelsPointer">,
  memory: WebAssembly.Memory,
  pixels: "rgb" | "rgba",
  course: Course,
  dpi?: number,
): Promise<Blob> {
  const { width, height, fileLink } = river;
  const rows = (first: number, count: number): Uint8Array =>
    new Uint8Array(memory.buffer, river.pixelsPointer() + first * width * 4, count * width * 4);
  return pngOf({ width, height, pixels, rows, texts: { [LINK_KEYWORD]: fileLink }, dpi }, course);
}
