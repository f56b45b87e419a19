import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { curveOf } from "../../src/apps/study/drawing.ts";
import { type Piece, SIDE } from "../../src/apps/study/piece.ts";
import { piecesIn } from "../../src/apps/study/real.ts";
import { thin } from "../../src/apps/study/thin.ts";
import { chainsOf, graphOf, isTreeLike, type Line, trace } from "../../src/apps/study/trace.ts";
import { chanceOf } from "../../src/browser/chance.ts";

const real = await piecesIn(new Uint8Array(readFileSync("src/apps/study/real.png")));

function pieceOf(...pixels: (readonly [x: number, y: number])[]): Piece {
  const piece = new Uint8Array(SIDE * SIDE);
  for (const [x, y] of pixels) piece[Math.round(y) * SIDE + Math.round(x)] = 1;
  return piece;
}

/** The pixels of a straight line, a pixel for each step of its longer axis. */
function straight(x: number, y: number, dx: number, dy: number): [number, number][] {
  const steps = Math.max(Math.abs(dx), Math.abs(dy));
  return Array.from({ length: steps + 1 }, (_, i) => [x + (i * dx) / steps, y + (i * dy) / steps]);
}

/** A circle, thinned to one pixel. */
function circle(radius: number): Piece {
  const piece = pieceOf(
    ...Array.from({ length: 1000 }, (_, i): [number, number] => [
      50 + radius * Math.cos((i * Math.PI) / 500),
      50 + radius * Math.sin((i * Math.PI) / 500),
    ]),
  );
  thin(piece, SIDE);
  return piece;
}

/** A tangle of wandering lines, thinned as pieces are. */
function random(seed: number): Piece {
  const chance = chanceOf(`skeleton ${seed}`);
  const piece = new Uint8Array(SIDE * SIDE);
  for (let line = 0; line < 8; line++) {
    let [x, y, way] = [chance(SIDE), chance(SIDE), chance(628) / 100];
    for (let step = 0; step < 150; step++) {
      if (x < 0 || y < 0 || x >= SIDE || y >= SIDE) break;
      piece[Math.floor(y) * SIDE + Math.floor(x)] = 1;
      way += (chance(101) - 50) / 150;
      x += 0.7 * Math.cos(way);
      y += 0.7 * Math.sin(way);
    }
  }
  thin(piece, SIDE);
  return piece;
}

const PIECES = [...Array.from({ length: 40 }, (_, seed) => random(seed)), ...real.map(({ piece }) => piece)];

function lengthOf(line: Line): number {
  return line
    .slice(1)
    .reduce((sum, [x, y], i) => sum + Math.hypot(x - (line[i]?.[0] ?? 0), y - (line[i]?.[1] ?? 0)), 0);
}

const pixelsOf = (piece: Piece): number[] => [...piece.keys()].filter((at) => piece[at]);

test("a river with a side branch is three lines, which meet in one point", () => {
  const lines = trace(pieceOf(...straight(0, 50, 99, 0), ...straight(40, 20, 0, 29)));
  expect(lines).toHaveLength(3);
  const ends = lines.flatMap((line) => [line[0], line.at(-1)]).map(String);
  expect(ends.filter((end) => ends.filter((other) => other === end).length === 3)).toHaveLength(3);
});

test("a corner is no confluence, and a cross is one of four", () => {
  expect(chainsOf(graphOf(pieceOf(...straight(10, 10, 20, 0), ...straight(30, 10, 0, 20))))).toHaveLength(1);
  expect(chainsOf(graphOf(pieceOf(...straight(10, 20, 20, 0), ...straight(20, 10, 0, 20))))).toHaveLength(4);
});

test("a pixel by itself is a dot, and rivers do not go on from the right edge at the left one", () => {
  expect(trace(pieceOf([7, 8])).map(curveOf)).toEqual(["M7.5 8.5h0"]);
  expect(trace(pieceOf([99, 10], [0, 11]))).toHaveLength(2);
});

test("a ring is one line that ends where it begins, as long as a circle", () => {
  for (const radius of [8, 20, 40]) {
    const [ring = [], ...others] = trace(circle(radius));
    expect(others).toEqual([]);
    expect(ring.at(-1)).toEqual(ring[0]);
    expect(lengthOf(ring)).toBeGreaterThan(2 * Math.PI * (radius - 0.6));
    expect(lengthOf(ring)).toBeLessThan(2 * Math.PI * (radius + 0.2));
  }
});

test.each([
  [80, 0],
  [80, 7],
  [80, 20],
  [80, 33],
  [80, 60],
  [80, 80],
  [13, -80],
])("the stairs of a slope of %i by %i become a straight line, as long as the slope", (dx, dy) => {
  const [line = [], ...others] = trace(pieceOf(...straight(10, 85 - Math.max(0, dy), dx, dy)));
  expect(others).toEqual([]);
  expect(lengthOf(line) / Math.hypot(dx, dy)).toBeCloseTo(1, 2);
  const [x, y] = [10.5, 85.5 - Math.max(0, dy)];
  const off = line.map(([px, py]) => Math.abs((px - x) * dy - (py - y) * dx) / Math.hypot(dx, dy));
  expect(Math.max(...off)).toBeLessThan(0.5);
  const turns = line.slice(2).map(([px, py], i) => {
    const [[ax = 0, ay = 0] = [], [bx = 0, by = 0] = []] = [line[i], line[i + 1]];
    return Math.abs((bx - ax) * (py - by) - (by - ay) * (px - bx)) / Math.hypot(bx - ax, by - ay);
  });
  // In the stairs, a step goes up to 0.7 off the direction of the one before.
  expect(Math.max(...turns)).toBeLessThan(0.02);
});

test("every pixel is in a line, and every step between two pixels in exactly one", () => {
  for (const piece of PIECES) {
    const graph = graphOf(piece);
    const chains = chainsOf(graph);
    expect(new Set(chains.flat())).toEqual(new Set(pixelsOf(piece)));
    const steps = chains.flatMap((chain) =>
      chain.slice(1).map((at, i) => [at, chain[i] ?? 0].sort((one, other) => one - other).join()),
    );
    expect(new Set(steps).size).toBe(steps.length);
    expect(steps).toHaveLength([...graph.values()].reduce((sum, joined) => sum + joined.length, 0) / 2);
  }
});

test("pixels are joined to neighbours, both ways, and always to those beside them", () => {
  for (const piece of PIECES) {
    const graph = graphOf(piece);
    for (const [at, joined] of graph) {
      expect(joined.every((next) => graph.get(next)?.includes(at))).toBe(true);
      expect(joined.every((next) => Math.abs((at % SIDE) - (next % SIDE)) <= 1)).toBe(true);
      if (at % SIDE < SIDE - 1 && piece[at + 1]) expect(joined).toContain(at + 1);
      if (piece[at + SIDE]) expect(joined).toContain(at + SIDE);
    }
  }
});

test("lines stay within three quarters of a pixel of their rivers, and keep their ends", () => {
  for (const piece of PIECES) {
    const chains = chainsOf(graphOf(piece));
    const lines = trace(piece);
    expect(lines).toHaveLength(chains.length);
    for (const [i, chain] of chains.entries()) {
      const off = chain.map((at, step) => {
        const [x = 0, y = 0] = lines[i]?.[step] ?? [];
        return Math.max(Math.abs(x - (at % SIDE) - 0.5), Math.abs(y - Math.floor(at / SIDE) - 0.5));
      });
      expect(Math.max(...off)).toBeLessThanOrEqual(0.75);
    }
    for (const [at, joined] of graphOf(piece)) {
      const end = [(at % SIDE) + 0.5, Math.floor(at / SIDE) + 0.5];
      if (joined.length === 1) expect(lines.flat()).toContainEqual(end);
    }
  }
});

test("lines are as long as their rivers, but for the stairs", () => {
  for (const piece of PIECES) {
    const inPixels = chainsOf(graphOf(piece)).reduce((sum, chain) => sum + chain.length - 1, 0);
    const length = trace(piece).reduce((sum, line) => sum + lengthOf(line), 0);
    // A step is from 1, along an axis, to 1.41, on a diagonal.
    expect(length / inPixels).toBeGreaterThan(0.9);
    expect(length / inPixels).toBeLessThan(1.3);
  }
});

test("real pieces with lakes and canals are left out, and most are not", () => {
  const names = real.filter(({ piece }) => !isTreeLike(piece)).map(({ river }) => river);
  expect(names).toContain("Don");
  expect(names).toContain("Euphrates");
  expect(real.length - names.length).toBe(32);
  expect(isTreeLike(circle(20))).toBe(true);
});
