import { readFileSync } from "node:fs";
import { decode } from "fast-png";
import { afterEach, expect, test, vi } from "vitest";
import { type Canvas, RiverPlayer } from "../../src/player/river-player.ts";
import { differing, engine, memory, pixelsOf } from "../core.ts";
import { Display, Image } from "../display.ts";

const SIZE = { width: 320, height: 300, ratio: 1 };
const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&style=ink&labels=many";

afterEach(() => vi.unstubAllGlobals());

/** A finished river with its picture, which is still to be painted. */
function finished(link: string, { width, height, ratio } = SIZE): engine.River {
  const river = new engine.River(link);
  river.resize(width, height, ratio);
  while (river.advance(1000));
  return river;
}

/** The pixels of a river without what is laid over it. */
function bareOf(river: engine.River): Uint8Array {
  while (river.paint(true));
  return new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
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
])("%s has its golden pixels", (name) => {
  const { link, width, height, data } = golden(name);
  const rgb = pixelsOf(finished(link, { width, height, ratio: 1 })).filter((_, i) => i % 4 !== 3);
  expect(Buffer.compare(rgb, Uint8Array.from(data))).toBe(0);
});

test("labels stay when only the style changes, can be left for later, and go when they are not asked for", () => {
  const river = finished(LINK);
  const bare = bareOf(river);
  const labelled = pixelsOf(river);
  expect(differing(bare, labelled)).toBeGreaterThan(500);
  expect(river.labels().length).toBeGreaterThan(3);
  river.change(LINK.replace("ink", "dark"));
  river.change(LINK);
  // They were there before: there is nothing to leave.
  expect(Buffer.compare(bareOf(river), labelled)).toBe(0);
  river.change(LINK.replace("labels=many", "labels=none"));
  while (river.advance(1000));
  expect(Buffer.compare(pixelsOf(river), bare)).toBe(0);
});

test("letters are as large on a dense screen, so that the map has fewer of them", () => {
  const [usual, dense] = [1, 2].map((ratio) => {
    const river = finished(LINK, { width: 1000, height: 800, ratio });
    return differing(bareOf(river), pixelsOf(river));
  });
  expect(usual).toBeGreaterThan(500);
  expect(dense).toBeGreaterThan(0);
  expect(dense).not.toBe(usual);
});

test("a picture has the labels of a fresh one, whatever part of the map it showed before, and in whatever size", () => {
  const parts = [[], [0.2, 0.1, 0.5], [0.25, 0.12, 0.5], [0.3, 0.3, 0.2], [-0.1, -0.1, 1.2], []];
  const kept = finished(LINK);
  for (const { width, height, ratio } of [SIZE, { width: 500, height: 300, ratio: 2 }]) {
    kept.resize(width, height, ratio);
    for (const part of parts) {
      const fresh = finished(LINK, { width, height, ratio });
      for (const river of [kept, fresh]) river.frame(new Float32Array(part));
      expect(Buffer.compare(pixelsOf(kept), pixelsOf(fresh)), `${part} at ${width}`).toBe(0);
      expect(kept.labels()).toEqual(fresh.labels());
      fresh.free();
    }
  }
});

/** A player on a canvas without pixels, with its display, and what it failed with. */
function player(text = LINK) {
  vi.stubGlobal("ImageData", Image);
  const canvas = { width: 0, height: 0, getContext: () => ({ putImageData: () => {} }) } as unknown as Canvas;
  const display = new Display();
  const errors: unknown[] = [];
  const events = { sizeFor: () => SIZE, changed: () => {}, failed: (error: unknown) => void errors.push(error) };
  const one = new RiverPlayer({ engine, memory }, canvas, { text }, display, events);
  return { one, display, errors };
}

function frames(display: Display): void {
  for (let i = 0; i < 2000; i++) {
    if (!display.frame()) break;
  }
}

test("a player paints labels with every finished picture, and knows them", () => {
  const { one, display, errors } = player();
  const shown = () => pixelsOf(one.river as engine.River);
  one.start("watch");
  frames(display);
  expect(Buffer.compare(shown(), pixelsOf(finished(LINK)))).toBe(0);
  one.show({ text: `${LINK}&width=30` }, "settle");
  frames(display);
  expect(Buffer.compare(shown(), pixelsOf(finished(`${LINK}&width=30`)))).toBe(0);
  expect(one.labels.map(({ text }) => text)).toEqual((one.river as engine.River).labels().map(({ text }) => text));
  expect(one.labels.length).toBeGreaterThan(3);
  expect(errors).toEqual([]);
});
