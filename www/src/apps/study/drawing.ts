/** Draws traced lines as a path of SVG. */

import { svg } from "../../browser/dom.ts";
import { type Piece, SIDE } from "./piece.ts";
import { type Line, trace } from "./trace.ts";

/** The margin of a piece that is not shown: there, lines end because the piece does. */
const MARGIN = 2;

/** The side of what is shown of a piece, in pixels. */
export const SHOWN = SIDE - 2 * MARGIN;

/** Shows a piece. Its colours and the width of its lines are those of the style sheet. */
export function show(piece: Piece, picture: SVGSVGElement): void {
  picture.setAttribute("viewBox", `${MARGIN} ${MARGIN} ${SHOWN} ${SHOWN}`);
  picture.replaceChildren(svg("path", { d: trace(piece).map(curveOf).join("") }));
}

/** Writes a line as parabolas from the middle of each of its steps to the middle of the next. */
export function curveOf(line: Line): string {
  const [[x, y] = [0, 0], ...rest] = line;
  const curves = rest.map(([toX, toY], i) => {
    const [nextX, nextY] = rest[i + 1] ?? [toX, toY];
    return i + 1 < rest.length
      ? `Q${pair(toX, toY)} ${pair((toX + nextX) / 2, (toY + nextY) / 2)}`
      : `L${pair(toX, toY)}`;
  });
  return `M${pair(x, y)}${curves.length === 0 ? "h0" : curves.join("")}`;
}

function pair(x: number, y: number): string {
  return `${Math.round(100 * x) / 100} ${Math.round(100 * y) / 100}`;
}
