/** Writes points and lines as paths of SVG, in units. */

/** Writes points as lines without length, which are visible if their ends are round. */
export function dotsOf(points: Float32Array): string {
  let path = "";
  for (let i = 0; i + 1 < points.length; i += 2) path += `M${at(points, i)}h0`;
  return path;
}

/** Writes lines; one of a single point becomes a dot. */
export function linesOf(lines: readonly Float32Array[], areClosed = false): string {
  return lines.map((line) => lineOf(line) + (areClosed ? "z" : "")).join("");
}

function lineOf(points: Float32Array): string {
  if (points.length === 2) return dotsOf(points);
  const places: string[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) places.push(at(points, i));
  return places.length === 0 ? "" : `M${places.join("L")}`;
}

/** Writes a point in hundredths of a unit. */
function at(points: Float32Array, i: number): string {
  return `${rounded(points[i])} ${rounded(points[i + 1])}`;
}

function rounded(x = 0): number {
  return Math.round(x * 100) / 100;
}
