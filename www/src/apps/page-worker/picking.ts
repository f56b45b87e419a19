/** Finds what lies nearest to a point. Points are in shares of the map's sides; distances are in widths of the map. */

export interface Point {
  x: number;
  y: number;
}

/** Something that lies along a line, or at points, and reaches as far to all sides. */
export interface Shape {
  /** x and y in turn. */
  line: ArrayLike<number>;
  half: number;
  /** True if nothing of it lies between the points: they are letters, which may stand far apart. */
  isSpaced?: boolean;
}

/**
 * Returns the shapes within reach of a point, the nearest first. `tall` is the map's height over its width. Of shapes
 * that are as near, the first comes first.
 */
export function nearest<S extends Shape>(shapes: readonly S[], at: Point, reach: number, tall: number): S[] {
  return shapes
    .map((shape) => ({ shape, away: Math.max(0, awayFrom(shape, at, tall) - shape.half) }))
    .filter(({ away }) => away <= reach)
    .sort((one, other) => one.away - other.away)
    .map(({ shape }) => shape);
}

/** Returns the distance from a point to a line, or the nearest of its points; infinite if it has none. */
export function awayFrom({ line, isSpaced }: Omit<Shape, "half">, { x, y }: Point, tall: number): number {
  const pointOf = (i: number): Point => ({ x: (line[i] ?? 0) - x, y: ((line[i + 1] ?? 0) - y) * tall });
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 1 < line.length; i += 2) {
    const from = pointOf(isSpaced ? i : Math.max(0, i - 2));
    least = Math.min(least, fromOrigin(from, pointOf(i)));
  }
  return least;
}

/** Returns the distance from the origin to a piece of a straight line. */
function fromOrigin(from: Point, to: Point): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length2 = dx * dx + dy * dy;
  const along = length2 === 0 ? 0 : Math.min(1, Math.max(0, -(from.x * dx + from.y * dy) / length2));
  return Math.hypot(from.x + along * dx, from.y + along * dy);
}
