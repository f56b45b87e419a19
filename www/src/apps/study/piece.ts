/** Pieces of river networks, real or grown: lines of one pixel in a square. */

export const SIDE = 100;

/** The pixels of a piece, row by row: 1 where there is a river. */
export type Piece = Uint8Array;

/** The measures of a piece, each of which can be given as a reason. */
export interface Measured {
  /** The number of river pixels. */
  length: number;
  /** The numbers of confluences and of ends per hundred river pixels. */
  confluences: number;
  ends: number;
  /** The straight distance over the distance along the river, for stretches of 24 pixels. */
  straightness: number;
}

/** The length in pixels of a stretch that is measured for straightness. */
const WAY = 24;

/** The steps to the pixels around one, clockwise. */
const AROUND = [-SIDE, 1 - SIDE, 1, SIDE + 1, SIDE, SIDE - 1, -1, -SIDE - 1];

/** Returns the number of river pixels of a piece. */
export function lengthOf(piece: Piece): number {
  return piece.reduce((sum, is) => sum + is, 0);
}

export function measure(piece: Piece): Measured {
  let length = 0;
  let confluences = 0;
  let ends = 0;
  const straight: number[] = [];
  forEachInside(piece, (at) => {
    length++;
    const branches = branchesAt(piece, at);
    if (branches >= 3) confluences++;
    if (branches !== 1) return;
    ends++;
    straight.push(...straightnessFrom(piece, at));
  });
  return {
    length,
    confluences: (100 * confluences) / length,
    ends: (100 * ends) / length,
    straightness: straight.reduce((sum, one) => sum + one, 0) / straight.length,
  };
}

/**
 * Returns whether a piece has enough river everywhere and no large gap. The real pieces were chosen by the same rules.
 */
export function isWellCovered(piece: Piece): boolean {
  let inside = 0;
  const quarters = [0, 0, 0, 0];
  piece.forEach((is, at) => {
    if (!is) return;
    inside++;
    const quarter = Number(at % SIDE >= SIDE / 2) + 2 * Number(at >= (SIDE * SIDE) / 2);
    quarters[quarter] = (quarters[quarter] ?? 0) + 1;
  });
  if (inside < LEAST || inside > MOST || quarters.some((count) => count < LEAST_IN_QUARTER)) return false;
  return measure(piece).confluences * inside >= 200 && largestGap(piece) <= WIDEST_GAP;
}

const LEAST = 220;
const MOST = 1400;
const LEAST_IN_QUARTER = 25;
/** The radius of the largest empty disc, in pixels. */
const WIDEST_GAP = 27;

/** Returns the largest distance from any river inside a piece, sampled at every fourth pixel. */
function largestGap(piece: Piece): number {
  const rivers: [x: number, y: number][] = [];
  piece.forEach((is, at) => {
    if (is) rivers.push([at % SIDE, Math.floor(at / SIDE)]);
  });
  let largest = 0;
  for (let y = 2; y < SIDE; y += 4) {
    for (let x = 2; x < SIDE; x += 4) {
      const nearest = Math.min(...rivers.map(([rx, ry]) => (rx - x) ** 2 + (ry - y) ** 2));
      largest = Math.max(largest, Math.min(Math.sqrt(nearest), x, y, SIDE - x, SIDE - y));
    }
  }
  return largest;
}

/** Visits the river pixels that are not on the edge, beyond which rivers continue. */
function forEachInside(piece: Piece, visit: (at: number) => void): void {
  for (let y = 1; y < SIDE - 1; y++) {
    for (let x = 1; x < SIDE - 1; x++) {
      const at = y * SIDE + x;
      if (piece[at]) visit(at);
    }
  }
}

/** Counts the rivers that leave a pixel: the changes from empty to river around it. */
function branchesAt(piece: Piece, at: number): number {
  return AROUND.filter((step, i) => piece[at + step] && !piece[at + (AROUND[(i + 7) % 8] ?? 0)]).length;
}

/** Measures the straightness of successive stretches from an end to the next confluence. */
function straightnessFrom(piece: Piece, end: number): number[] {
  const found: number[] = [];
  const seen = new Set([end]);
  let from = end;
  let steps = 0;
  for (let at: number | undefined = end; at !== undefined; steps++) {
    if (steps === WAY) {
      found.push(distance(from, at) / WAY);
      [from, steps] = [at, 0];
    }
    const here: number = at;
    at = AROUND.map((step) => here + step).find((next) => piece[next] && isInside(next) && !seen.has(next));
    if (at !== undefined) seen.add(at);
    if (at !== undefined && branchesAt(piece, at) >= 3) break;
  }
  return found;
}

function isInside(at: number): boolean {
  const [x, y] = [at % SIDE, Math.floor(at / SIDE)];
  return x > 0 && y > 0 && x < SIDE - 1 && y < SIDE - 1;
}

function distance(one: number, other: number): number {
  const [dx, dy] = [(one % SIDE) - (other % SIDE), Math.floor(one / SIDE) - Math.floor(other / SIDE)];
  // Diagonal steps are longer than straight ones, but both count as one.
  return Math.max(Math.abs(dx), Math.abs(dy));
}
