/**
 * Traces pieces: makes smooth lines of rivers of one pixel. Real and grown pieces are traced alike, so that nothing but
 * their rivers tells them apart.
 */

import { type Piece, SIDE } from "./piece.ts";

type Point = readonly [x: number, y: number];

/** Points from one end to the other, in pixels. A ring ends where it begins. */
export type Line = Point[];

/** The rivers of a piece as a graph: the pixels, each with those that it is joined to. */
type Graph = ReadonlyMap<number, readonly number[]>;

/** Returns the lines of a piece, each between confluences and ends. */
export function trace(piece: Piece): Line[] {
  const graph = graphOf(piece);
  const places = smooth(graph);
  return chainsOf(graph).map((chain) => chain.map((at) => places.get(at) ?? centre(at)));
}

/**
 * Returns the graph of a piece. Pixels are joined to those beside them, and to diagonal ones that no pixel beside both
 * joins already, so that no corner becomes a triangle.
 */
export function graphOf(piece: Piece): Graph {
  const isRiver = (x: number, y: number): boolean =>
    x >= 0 && y >= 0 && x < SIDE && y < SIDE && piece[y * SIDE + x] === 1;
  const graph = new Map<number, number[]>();
  for (const [at, is] of piece.entries()) {
    if (!is) continue;
    const [x, y] = [at % SIDE, Math.floor(at / SIDE)];
    const joined = AROUND.filter(
      ([dx, dy]) => isRiver(x + dx, y + dy) && (dx === 0 || dy === 0 || !(isRiver(x + dx, y) || isRiver(x, y + dy))),
    );
    graph.set(
      at,
      joined.map(([dx, dy]) => at + dy * SIDE + dx),
    );
  }
  return graph;
}

const AROUND: readonly Point[] = [-1, 0, 1].flatMap((dy) =>
  [-1, 0, 1].filter((dx) => dx !== 0 || dy !== 0).map((dx): Point => [dx, dy]),
);

/** Returns all ways between pixels that do not have exactly two neighbours, then the rings, which have no such pixel. */
export function chainsOf(graph: Graph): number[][] {
  const walked = new Set<number>();
  const chains: number[][] = [];
  const isInside = (at: number): boolean => graph.get(at)?.length === 2;
  const follow = (from: number, first: number): void => {
    const chain = [from];
    for (let next: number | undefined = first; next !== undefined; ) {
      const last: number = chain.at(-1) ?? from;
      walked.add(linkOf(last, next));
      chain.push(next);
      next = isInside(next) && next !== from ? graph.get(next)?.find((one) => one !== last) : undefined;
    }
    chains.push(chain);
  };
  const followAll = (from: number): void => {
    for (const next of graph.get(from) ?? []) if (!walked.has(linkOf(from, next))) follow(from, next);
  };
  for (const [at, { length }] of graph) {
    if (length === 0) chains.push([at]);
    else if (length !== 2) followAll(at);
  }
  for (const at of graph.keys()) followAll(at);
  return chains;
}

/**
 * Returns whether a piece has at most two rings, and at most two rivers that reach neither each other nor its edge.
 * Maps of the world have more where there are lakes and canals, which nobody grows: they would give real pieces away.
 */
export function isTreeLike(piece: Piece): boolean {
  const graph = graphOf(piece);
  const networks = networksOf(graph);
  const links = [...graph.values()].reduce((sum, joined) => sum + joined.length, 0) / 2;
  const isOnEdge = (at: number): boolean =>
    [0, SIDE - 1].some((edge) => at % SIDE === edge || Math.floor(at / SIDE) === edge);
  return links - graph.size + networks.length <= 2 && networks.filter((one) => !one.some(isOnEdge)).length <= 2;
}

/** Returns the pixels that are joined to each other, directly or through others. */
function networksOf(graph: Graph): number[][] {
  const seen = new Set<number>();
  return [...graph.keys()].flatMap((first) => {
    if (seen.has(first)) return [];
    const network = new Set([first]);
    // The loop also visits pixels that are added to the set meanwhile.
    for (const at of network) for (const next of graph.get(at) ?? []) network.add(next);
    for (const at of network) seen.add(at);
    return [[...network]];
  });
}

/** Returns a number for the link of two pixels, the same from both sides. */
function linkOf(one: number, other: number): number {
  return Math.min(one, other) * SIDE * SIDE + Math.max(one, other);
}

/** The number of times that lines are tightened, and then rounded. */
const TIGHTENED = 40;
const ROUNDED = 3;
/** The distances from a pixel's centre, along each axis, that a line keeps to meanwhile. */
const SLACK = { tightened: 0.5, rounded: 0.75 };

/**
 * Returns a place for each pixel. Lines are pulled taut within their pixels, which takes the steps out of slopes and
 * leaves all bends that are larger than a pixel; then their corners are rounded. Ends stay.
 */
function smooth(graph: Graph): Map<number, Point> {
  let places = new Map<number, Point>([...graph.keys()].map((at) => [at, centre(at)]));
  for (let i = 0; i < TIGHTENED + ROUNDED; i++) {
    const from = places;
    const slack = i < TIGHTENED ? SLACK.tightened : SLACK.rounded;
    places = new Map([...graph].map(([at, joined]) => [at, near(pulled(from, at, joined), centre(at), slack)]));
  }
  return places;
}

/** Returns the point half way to the middle of a pixel's neighbours. Ends do not move. */
function pulled(places: ReadonlyMap<number, Point>, at: number, joined: readonly number[]): Point {
  const [x, y] = places.get(at) ?? centre(at);
  if (joined.length < 2) return [x, y];
  const mean = (axis: 0 | 1): number =>
    joined.reduce((sum, one) => sum + (places.get(one)?.[axis] ?? 0), 0) / joined.length;
  return [(x + mean(0)) / 2, (y + mean(1)) / 2];
}

function near([x, y]: Point, [toX, toY]: Point, slack: number): Point {
  const within = (value: number, around: number): number => Math.min(around + slack, Math.max(around - slack, value));
  return [within(x, toX), within(y, toY)];
}

function centre(at: number): Point {
  return [(at % SIDE) + 0.5, Math.floor(at / SIDE) + 0.5];
}
