import { readFileSync } from "node:fs";
import { decode } from "fast-png";
import { afterEach, expect, test, vi } from "vitest";
import type { PageError } from "../../src/engine/errors.ts";
import { annotate } from "../../src/player/annotator.ts";
import { type Canvas, RiverPlayer } from "../../src/player/river-player.ts";
import { differing, engine, memory, pixelsOf } from "../core.ts";
import { Display, Image } from "../display.ts";
import { teller } from "../tell.ts";

const SIZE = { width: 320, height: 300, ratio: 1 };
const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&style=ink&labels=many";

afterEach(() => vi.unstubAllGlobals());

/** A finished river with its picture, unlabelled. */
function finished(link: string, { width, height } = SIZE): engine.River {
  const river = new engine.River(link);
  river.resize(width, height);
  while (river.advance(1000));
  while (river.paint());
  return river;
}

function golden(name: string): { link: string; width: number; height: number; data: ArrayLike<number> } {
  const { text, width, height, data } = decode(readFileSync(`../tests/golden/${name}.png`));
  const link = Object.values(text)[0];
  if (link === undefined) throw new Error(`${name} carries no link`);
  return { link, width, height, data };
}

test.each([
  "labels-atlas",
  "labels-ink",
  "labels-dark",
  "cartouche",
  "cartouche-plain",
  "scenery-ink",
  "scenery-basins",
])("%s has its golden pixels through two modules", (name) => {
  const { link, width, height, data } = golden(name);
  const river = finished(link, { width, height, ratio: 1 });
  annotate(river, teller);
  const rgb = pixelsOf(river).filter((_, i) => i % 4 !== 3);
  expect(Buffer.compare(rgb, Uint8Array.from(data))).toBe(0);
});

test("an annotation is wanted by finished rivers whose recipe asks for labels, once", () => {
  const river = new engine.River(LINK);
  river.resize(SIZE.width, SIZE.height);
  expect(river.wantsAnnotation()).toBe(false);
  while (river.advance(1000));
  expect(river.wantsAnnotation()).toBe(true);
  annotate(river, teller);
  expect(river.wantsAnnotation()).toBe(false);
  const labelled = pixelsOf(river);
  // It stays when the style changes, and goes when the rivers do.
  river.change(`${LINK.replace("ink", "dark")}`);
  expect(river.wantsAnnotation()).toBe(false);
  river.change(LINK);
  expect(Buffer.compare(pixelsOf(river), labelled)).toBe(0);
  river.change(`${LINK}&width=30`);
  while (river.advance(1000));
  expect(river.wantsAnnotation()).toBe(true);
  river.change(LINK.replace("labels=many", "labels=none"));
  while (river.advance(1000));
  expect(river.wantsAnnotation()).toBe(false);
});

test("letters are as large on a dense screen, so that the map has fewer of them", () => {
  const [usual, dense] = [1, 2].map((ratio) => {
    const river = finished(LINK, { width: 1000, height: 800, ratio });
    const bare = pixelsOf(river);
    annotate(river, teller, ratio);
    return differing(bare, pixelsOf(river));
  });
  expect(usual).toBeGreaterThan(500);
  expect(dense).toBeGreaterThan(0);
  expect(dense).not.toBe(usual);
});

/** A player on a canvas without pixels, with its display, what it failed with, and how often teller were fetched. */
function player(load: () => Promise<typeof teller>, text = LINK) {
  vi.stubGlobal("ImageData", Image);
  const canvas = { width: 0, height: 0, getContext: () => ({ putImageData: () => {} }) } as unknown as Canvas;
  const display = new Display();
  const errors: PageError[] = [];
  const loadTeller = vi.fn(load);
  const events = {
    sizeFor: () => SIZE,
    changed: () => {},
    failed: (error: unknown) => void errors.push(error as PageError),
  };
  const one = new RiverPlayer({ engine, memory, loadTeller }, canvas, { text }, display, events);
  return { one, display, errors, loadTeller };
}

async function frames(display: Display): Promise<void> {
  for (let i = 0; i < 2000; i++) {
    if (!display.frame()) break;
  }
  await Promise.resolve();
}

test("what makes labels is fetched while a map grows that asks for them, and for no other", () => {
  for (const [link, times] of [
    [LINK, 1],
    [LINK.replace("many", "none"), 0],
    ["seed=kauri&attractors=300", 1],
  ] as const) {
    const { one, loadTeller } = player(() => Promise.resolve(teller), link);
    one.start("watch");
    expect(loadTeller, link).toHaveBeenCalledTimes(times);
  }
});

test("labels come when what makes them has come, and with every picture after that", async () => {
  const { one, display, errors, loadTeller } = player(() => Promise.resolve(teller));
  const shown = () => pixelsOf(one.river as engine.River);
  one.start("watch");
  display.frame();
  for (let i = 0; i < 5; i++) await frames(display);
  const labelled = finished(LINK);
  annotate(labelled, teller);
  expect(Buffer.compare(shown(), pixelsOf(labelled))).toBe(0);
  one.show({ text: `${LINK}&width=30` }, "settle");
  await frames(display);
  const wider = finished(`${LINK}&width=30`);
  annotate(wider, teller);
  expect(Buffer.compare(shown(), pixelsOf(wider))).toBe(0);
  one.resize();
  expect(loadTeller).toHaveBeenCalledTimes(1);
  expect(errors).toEqual([]);
});

test("without what makes labels the map is shown bare, and its audience told once", async () => {
  const { one, display, errors, loadTeller } = player(() => Promise.reject(new TypeError("offline")));
  one.start("still");
  for (let i = 0; i < 5; i++) await frames(display);
  one.show({ text: `${LINK}&width=30` }, "settle");
  for (let i = 0; i < 5; i++) await frames(display);
  expect(one.state).toBe("finished");
  expect(Buffer.compare(pixelsOf(one.river as engine.River), pixelsOf(finished(`${LINK}&width=30`)))).toBe(0);
  // Once for each link, however often it is painted.
  expect(errors.map(({ code }) => code)).toEqual(["no-labels", "no-labels"]);
  // Ahead, which serves the first link, too, and for the second.
  expect(loadTeller).toHaveBeenCalledTimes(2);
});

test("a map that no labels can be made of is shown bare", async () => {
  const broken = class {
    constructor() {
      throw new WebAssembly.RuntimeError("unreachable");
    }
  } as unknown as typeof teller.FinishedMap;
  const { one, display, errors } = player(() => Promise.resolve({ ...teller, FinishedMap: broken }));
  one.start("still");
  for (let i = 0; i < 5; i++) await frames(display);
  expect(one.state).toBe("finished");
  expect(one.river?.wantsAnnotation()).toBe(false);
  expect(errors.map(({ code }) => code)).toEqual(["no-labels"]);
});
