import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { type Grown, grownPiece } from "../../src/apps/study/grown.ts";
import { isWellCovered, lengthOf, measure, SIDE } from "../../src/apps/study/piece.ts";
import { piecesIn } from "../../src/apps/study/real.ts";
import { linkBy, type Range, RECIPE_NAMES, RECIPES } from "../../src/apps/study/recipes.ts";
import { tellTale } from "../../src/apps/study/tell-tale.ts";
import { thin } from "../../src/apps/study/thin.ts";
import { chanceOf } from "../../src/browser/chance.ts";
import { engine, memory } from "../core.ts";
import { parameter, table } from "../table.ts";

/** A piece with straight rivers from some pixels to others. */
function piece(...lines: [x: number, y: number, dx: number, dy: number, length: number][]): Uint8Array {
  const pixels = new Uint8Array(SIDE * SIDE);
  for (const [x, y, dx, dy, length] of lines)
    for (let i = 0; i < length; i++) pixels[(y + i * dy) * SIDE + x + i * dx] = 1;
  return pixels;
}

test("a river from edge to edge has no end, and one with a side branch has an end and a confluence", () => {
  const alone = measure(piece([0, 50, 1, 0, SIDE]));
  expect(alone).toMatchObject({ length: 98, confluences: 0, ends: 0 });
  const { length, confluences, ends } = measure(piece([0, 50, 1, 0, SIDE], [40, 20, 0, 1, 30]));
  expect(Math.round((confluences * length) / 100)).toBe(1);
  expect(Math.round((ends * length) / 100)).toBe(1);
});

test("a straight river is straight, and one that turns is not", () => {
  const straight = measure(piece([10, 50, 1, 0, 80]));
  expect(straight.straightness).toBe(1);
  const bent = piece([10, 10, 1, 0, 12], [21, 10, 0, 1, 12], [10, 22, 1, 0, 12], [10, 22, 0, 1, 40]);
  expect(measure(bent).straightness).toBeLessThan(0.9);
});

test("a piece without river in a quarter of it is not well covered", () => {
  const full = piece(
    ...[10, 30, 50, 70, 90].map((y) => [0, y, 1, 0, SIDE] as [number, number, number, number, number]),
  );
  const joined = full.slice();
  for (const [x, y] of [
    [10, 11],
    [10, 12],
    [30, 31],
    [30, 32],
    [20, 51],
    [20, 52],
  ] as const)
    joined[y * SIDE + x] = 1;
  expect(isWellCovered(joined)).toBe(true);
  expect(isWellCovered(full), "no confluence").toBe(false);
  expect(isWellCovered(joined.map((is, at) => (at % SIDE < 50 ? is : 0)))).toBe(false);
});

test("a thick line becomes one of a pixel, as long as it was", () => {
  const thick = piece([5, 40, 1, 0, 90], [5, 41, 1, 0, 90], [5, 42, 1, 0, 90]);
  thin(thick, SIDE);
  const columns = Array.from({ length: SIDE }, (_, x) => thick.filter((is, at) => is && at % SIDE === x).length);
  // Its ends may lean.
  expect(Math.max(...columns)).toBeLessThanOrEqual(2);
  expect(columns.filter((count) => count === 1).length).toBeGreaterThan(80);
});

test("stairs become a slope without corners, and stay in one", () => {
  const stairs = new Uint8Array(SIDE * SIDE);
  for (let i = 10; i < 60; i++)
    for (const [x, y] of [
      [i, i],
      [i + 1, i],
    ] as const)
      stairs[y * SIDE + x] = 1;
  thin(stairs, SIDE);
  for (let i = 12; i < 58; i++)
    expect([stairs[i * SIDE + i], stairs[i * SIDE + i + 1]].reduce((a, b) => (a ?? 0) + (b ?? 0))).toBe(1);
  expect(Math.round((measure(stairs).ends * measure(stairs).length) / 100)).toBe(2);
});

test("what is told of a piece is the measure that is farthest off", () => {
  const real = [1, 2, 3].map((one) => ({
    length: 500 + one,
    confluences: one,
    ends: one,
    straightness: 0.8 + one / 100,
  }));
  expect(tellTale({ length: 502, confluences: 2, ends: 9, straightness: 0.82 }, real)).toMatch(
    /^it had more short streams/,
  );
  expect(tellTale({ length: 502, confluences: 2, ends: 2, straightness: 0.5 }, real)).toMatch(/wound more/);
  expect(tellTale({ length: 502, confluences: 2, ends: 2, straightness: Number.NaN }, real)).toBeUndefined();
});

test("every piece of the world's rivers says where it is, and is well covered", async () => {
  const png = readFileSync("src/apps/study/real.png");
  expect(png.readUInt32BE(16)).toBe(11 * SIDE);
  const pieces = await piecesIn(new Uint8Array(png));
  expect(pieces).toHaveLength(44);
  for (const { kilometresPerPixel, piece } of pieces) {
    expect(kilometresPerPixel).toBeGreaterThanOrEqual(2.5);
    expect(isWellCovered(piece)).toBe(true);
  }
});

test.each(RECIPE_NAMES)("recipes of %s are read as they are written, with values from all of their range", (name) => {
  const { ranges, attractors } = RECIPES[name] as { ranges: Record<string, Range>; attractors: Range };
  const chance = chanceOf(`recipes ${name}`);
  const seen: Record<string, number[]> = {};
  for (let i = 0; i < 300; i++) {
    const link = linkBy(name, "kauri", chance);
    const read = engine.readLink(link);
    expect(read.notices, link).toEqual([]);
    const [given, kept] = [new URLSearchParams(link), new URLSearchParams(read.link)];
    for (const [key, value] of given) {
      if (key === "preset") continue;
      const row = parameter(key);
      // Links leave defaults out.
      if (kept.has(key)) expect(kept.get(key), key).toBe(value);
      else if ("default" in row) expect(String(row.default), key).toBe(value);
      if ("min" in row) expect(Number(value)).toBeGreaterThanOrEqual(row.min);
      if ("max" in row) expect(Number(value)).toBeLessThanOrEqual(row.max);
    }
    const nodes = (380 / Math.sqrt(Number(given.get("attractors")))) as number;
    for (const key of [...Object.keys(ranges), "attractors"]) {
      const value = Number(given.get(key));
      seen[key] ??= [];
      seen[key].push(key === "trim" ? value / nodes : value);
    }
  }
  for (const [key, { least, most, step }] of Object.entries({ ...ranges, attractors })) {
    const [lowest, highest] = [Math.min(...(seen[key] ?? [])), Math.max(...(seen[key] ?? []))];
    // Trim is rounded to whole units.
    expect(lowest, key).toBeGreaterThanOrEqual(least - step / 2);
    expect(highest, key).toBeLessThanOrEqual(most + step / 2);
    expect(highest - lowest, key).toBeGreaterThan(0.9 * (most - least));
  }
});

test("there are seven recipes: the six variants of the paper, and drainage", () => {
  const presets = RECIPE_NAMES.map((name) => new URLSearchParams(RECIPES[name].link).get("preset"));
  expect(presets).toEqual([...table.presets.map(({ name }) => name), null]);
});

test.each(RECIPE_NAMES)(
  "a piece grown by %s is as well covered as those of the world, and as long as it should be",
  async (by) => {
    for (const length of [420, 700]) {
      const order = { by, length, seedOf: () => "kauri", chance: chanceOf(`${by} ${length}`) };
      const { seed, piece } = await grownPiece({ engine, memory }, order);
      expect(seed).toBe("kauri");
      expect(isWellCovered(piece)).toBe(true);
      expect(Math.abs(lengthOf(piece) / length - 1)).toBeLessThan(0.12);
    }
  },
);

test("the same chance grows the same piece", async () => {
  const grow = (): Promise<Grown> =>
    grownPiece(
      { engine, memory },
      { by: "trimmedCurl", length: 500, seedOf: () => "kauri", chance: chanceOf("twice") },
    );
  expect(await grow()).toEqual(await grow());
});
