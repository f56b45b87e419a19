/** Writes points and lines as paths of SVG, in hundredths of a unit. */

type Point = readonly [x: number, y: number];

/** Writes points as lines without length, which are visible if their ends are round. */
export function dotsOf(points: Float32Array): string {
  return pointsOf(points)
    .map((point) => `M${point.join(" ")}h0`)
    .join("");
}

/** Writes lines. Those of a single point become dots. */
export function linesOf(lines: readonly Float32Array[]): string {
  return lines.map(lineOf).join("");
}

function lineOf(line: Float32Array): string {
  const points = pointsOf(line);
  return points.length < 2 ? dotsOf(line) : `M${points.map((point) => point.join(" ")).join("L")}`;
}

/**
 * Writes rings smoothly: parabolas from the middle of each side to the middle of the next, as the core draws areas.
 * Rings of fewer than three points are left out.
 */
export function ringsOf(rings: readonly Float32Array[]): string {
  return rings.map((ring) => ringOf(pointsOf(ring))).join("");
}

function ringOf(points: readonly Point[]): string {
  const last = points.at(-1);
  if (!last || points.length < 3) return "";
  const pieces = points.map((point, i) => {
    const [x, y] = middle(point, points[(i + 1) % points.length] ?? point);
    return `Q${point.join(" ")} ${x} ${y}`;
  });
  return `M${middle(last, points[0] ?? last).join(" ")}${pieces.join("")}z`;
}

function middle([x, y]: Point, [toX, toY]: Point): Point {
  return [rounded((x + toX) / 2), rounded((y + toY) / 2)];
}

function pointsOf(line: Float32Array): Point[] {
  const points: Point[] = [];
  for (let i = 0; i + 1 < line.length; i += 2) points.push([rounded(line[i]), rounded(line[i + 1])]);
  return points;
}

function rounded(x = 0): number {
  return Math.round(x * 100) / 100;
}
