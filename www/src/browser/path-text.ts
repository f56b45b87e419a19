/** Writes points and lines, each a list of x and y in turn, as paths of SVG. */

/** The decimal places of numbers unless said otherwise: hundredths of a map's unit. */
const PLACES = 2;

type Point = readonly [x: number, y: number];

/** Writes points as lines without length, which are visible if their ends are round. */
export function dotsOf(points: Float32Array, places = PLACES): string {
  return pointsOf(points, places)
    .map((point) => `M${point.join(" ")}h0`)
    .join("");
}

/** Writes a line, closed or open; one of a single point becomes a dot. */
export function lineOf(line: Float32Array, places = PLACES, isClosed = false): string {
  const points = pointsOf(line, places);
  if (points.length < 2) return dotsOf(line, places);
  return `M${points.map((point) => point.join(" ")).join("L")}${isClosed ? "z" : ""}`;
}

/** Writes open lines. */
export function linesOf(lines: readonly Float32Array[]): string {
  return lines.map((line) => lineOf(line)).join("");
}

/**
 * Writes rings smoothly: parabolas from the middle of each side to the middle of the next, as the core draws areas.
 * Rings of fewer than three points are left out.
 */
export function ringsOf(rings: readonly Float32Array[]): string {
  return rings.map((ring) => ringOf(pointsOf(ring, PLACES))).join("");
}

function ringOf(points: readonly Point[]): string {
  const last = points.at(-1);
  if (!last || points.length < 3) return "";
  const pieces = points.map((point, i) => {
    const to = middle(point, points[(i + 1) % points.length] ?? point);
    return `Q${point.join(" ")} ${to.join(" ")}`;
  });
  return `M${middle(last, points[0] ?? last).join(" ")}${pieces.join("")}z`;
}

function middle([x, y]: Point, [toX, toY]: Point): Point {
  return [rounded((x + toX) / 2, PLACES), rounded((y + toY) / 2, PLACES)];
}

function pointsOf(line: Float32Array, places: number): Point[] {
  const points: Point[] = [];
  for (let i = 0; i + 1 < line.length; i += 2) points.push([rounded(line[i], places), rounded(line[i + 1], places)]);
  return points;
}

function rounded(x = 0, places = PLACES): number {
  return Math.round(x * 10 ** places) / 10 ** places;
}
