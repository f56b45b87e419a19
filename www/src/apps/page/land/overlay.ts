/** Draws lines over the picture, in fractions of its width and height. */

import { svg } from "../../../browser/dom.ts";
import { lineOf } from "../../../browser/path-text.ts";
import type { Lines } from "../../../engine/whole.ts";
import { LINE_KINDS, type Line, pointsOf } from "./sketch.ts";

/** Ten-thousandths of the map. */
const PLACES = 4;

/** Shows the lines that are kept of a drawing, and lines as the pen left them. */
export function showLines(sheet: SVGSVGElement, kept: Lines, raw: readonly Line[]): void {
  sheet.replaceChildren(
    ...kept.coasts.map((line) => path(line, "coast", true)),
    ...kept.ridges.map((line) => path(line, "ridge", false)),
    ...kept.rivers.map((line) => path(line, "river", false)),
    ...LINE_KINDS.flatMap((kind) => pointsOf(raw, kind).map((line) => path(line, `${kind} raw`, false))),
  );
}

function path(points: Float32Array, name: string, isClosed: boolean): SVGPathElement {
  // The sheet is stretched to the map's shape; its lines are not.
  return svg("path", {
    class: name,
    d: lineOf(points, PLACES, isClosed),
    "vector-effect": "non-scaling-stroke",
  });
}
