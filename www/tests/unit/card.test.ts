import { readFileSync } from "node:fs";
import { decode } from "fast-png";
import { beforeAll, expect, test } from "vitest";
import type { Course } from "../../src/files/course.ts";
import { CARDS } from "../../src/files/order.ts";
import { pictureOf } from "../../src/files/picture.ts";
import { engine, memory } from "../whole.ts";

const COURSE: Course = { tell: () => {}, pause: () => Promise.resolve() };
/** An island of few rivers on plain paper: what is not paper is land or a letter. */
const LINK = "country=usual&seed=Ardenwold&land=island&style=ink&labels=none&attractors=400&meander=none";

/** No test depends on speed; this only ends one that hangs. */
const SLOWEST_MS = 120_000;

interface Picture {
  width: number;
  height: number;
  /** Three bytes a pixel. */
  data: Uint8Array;
  /** Returns whether there is ink at a pixel. */
  isInk(x: number, y: number): boolean;
}

async function pictureFor(kind: keyof typeof CARDS, link: string): Promise<Picture> {
  const file = await pictureOf({ kind, link: engine.readLink(link).link }, { engine, memory }, COURSE);
  const { width, height, data, channels } = decode(new Uint8Array(await file.arrayBuffer()));
  const at = (x: number, y: number): number[] => [...data.subarray((y * width + x) * channels).subarray(0, 3)];
  const paper = at(2, 2);
  const isInk = (x: number, y: number): boolean => at(x, y).some((value, i) => Math.abs(value - (paper[i] ?? 0)) > 40);
  return { width, height, data: Uint8Array.from(data), isInk };
}

const pictures = new Map<string, Picture>();
beforeAll(async () => {
  for (const kind of ["card", "portrait"] as const) pictures.set(kind, await pictureFor(kind, LINK));
}, SLOWEST_MS);

/** The first and the last row with ink of each band that has some without a gap. */
function bands({ width, height, isInk }: Picture): [first: number, last: number][] {
  const found: [number, number][] = [];
  for (let y = 0; y < height; y++) {
    if (!Array.from({ length: width }, (_, x) => x).some((x) => isInk(x, y))) continue;
    const last = found.at(-1);
    if (last && last[1] >= y - 2) last[1] = y;
    else found.push([y, y]);
  }
  return found;
}

for (const [kind, size] of Object.entries(CARDS)) {
  test(`a ${kind} has its size, and no land is cut off`, { timeout: SLOWEST_MS }, () => {
    const { width, height, isInk } = pictures.get(kind) as Picture;
    expect({ width, height }).toEqual(size);
    for (let x = 0; x < width; x++) for (const y of [5, height - 6]) expect(isInk(x, y)).toBe(false);
    for (let y = 0; y < height; y++) for (const x of [5, width - 6]) expect(isInk(x, y)).toBe(false);
  });

  test(`the title of a ${kind} can be read where it is 300 pixels wide, and touches no land`, {
    timeout: SLOWEST_MS,
  }, () => {
    const [title, ...below] = bands(pictures.get(kind) as Picture);
    const [first = 0, last = 0] = title ?? [];
    // From the top of the d to the line; no letter reaches below it.
    expect(((last - first) * 300) / size.width).toBeGreaterThan(9);
    expect((below.at(-1)?.[0] ?? 0) - last).toBeGreaterThan(0.01 * size.height);
  });
}

test("a card is that of the library, and so that of the command line, to the bit", { timeout: SLOWEST_MS }, () => {
  // tests/golden.rs has the library draw it.
  const golden = decode(readFileSync(new URL("../../../tests/golden/card.png", import.meta.url)));
  expect(Buffer.compare(pictures.get("card")?.data ?? Buffer.of(), Buffer.from(golden.data))).toBe(0);
});

test("a title of two long words stands on the picture too", { timeout: SLOWEST_MS }, async () => {
  const { width, height, isInk } = await pictureFor("card", `${LINK}&seed=Wobegonshire+Severnmouth`);
  for (let y = 0; y < height; y++) for (const x of [5, width - 6]) expect(isInk(x, y)).toBe(false);
});
