/** Draws lines over the picture, in fractions of its width and height. */

import { svg } from "../../../browser/dom.ts";
import type { Lines } from "../../../engine/steer.ts";
import { LINE_KINDS, type Line, pointsOf } from "./sketch.ts";

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
  return svg("path", { class: name, d: pathText(points, isClosed), "vector-effect": "non-scaling-stroke" });
}

export function pathText(points: Float32Array, isClosed: boolean): string {
  const places: string[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) places.push(`${fraction(points[i])} ${fraction(points[i + 1])}`);
  // A line of one point, such as the mouth of a river, is a dot.
  if (places.length === 1) places.push(...places);
  return places.length === 0 ? "" : `M${places.join("L")}${isClosed ? "Z" : ""}`;
}

function fraction(x = 0): string {
  return String(Number(x.toFixed(4)));
}
