/** The picture of a river as PNG: exactly the core's pixels, and the river's link. */

import type { River } from "../engine/types.ts";
import type { Course } from "./course.ts";
import { pngOf } from "./png.ts";

/** The keyword under which pictures carry their link, as those of the command line do. */
const LINK_KEYWORD = "riverseed";

/** Writes the picture that a river has; `pixels` are "rgba" once its ground is cut out. */
export function riverPng(
  river: Pick<River, "width" | "height" | "link" | "pixelsPointer">,
  memory: WebAssembly.Memory,
  pixels: "rgb" | "rgba",
  course: Course,
): Promise<Blob> {
  const { width, height, link } = river;
  const rows = (first: number, count: number): Uint8Array =>
    new Uint8Array(memory.buffer, river.pixelsPointer() + first * width * 4, count * width * 4);
  return pngOf({ width, height, pixels, rows, texts: { [LINK_KEYWORD]: link } }, course);
}
