/** How long rivers grow, with the real engine, in frames of a clock that nothing but frames moves. */

import { expect, test } from "vitest";
import type { River } from "../../pkg-engine/riverseed_engine.js";
import { FrameLoop } from "../../src/player/frame-loop.ts";
import { differing, engine, pixelsOf } from "../core.ts";
import { Display } from "../display.ts";

/** Four seconds. */
const LONGEST = 240;

/** Watches a link's river from its first frame to its last, and says how many they were. */
function framesOf(
  link: string,
  [width, height]: readonly [number, number] = [16, 16],
  seen: (river: River, frame: number) => void = () => {},
): number {
  const river = new engine.River(engine.readLink(link).link);
  river.resize(width, height);
  const display = new Display();
  const loop = new FrameLoop(river, display, {
    draw: () => {
      seen(river, display.count);
      return false;
    },
    ready: () => {},
    changed: () => {},
    failed: (error) => {
      throw error;
    },
  });
  loop.watch();
  while (loop.state !== "finished" && display.count < 4 * LONGEST) display.frame();
  river.free();
  return display.count;
}

const OUTLINE = ".MzMzzMMzzMzM";
const LANDS = [
  ...[
    "rectangle",
    "island",
    "continent",
    "archipelago",
    "valley",
    "basin",
    "crescent",
    "twins",
    "long",
    "arms",
    "gulf",
  ],
  `drawn&outline=${OUTLINE}`,
];

/** Rivers from one short side to the other, and from all sides, with as many rounds as there may be. */
const REST = ["sides=w&mouths=1&meander-rounds=6", "sides=nesw&mouths=12&meander-rounds=400"];

for (const growth of ["colonize&attractors=600", "brownian&sensitivity=64", "drainage&attractors=600&captures=24"])
  test(`a river of any shape and land ends within four seconds: ${growth}`, () => {
    for (const [i, land] of LANDS.entries())
      for (const [j, aspect] of [0.25, 1, 3, 4].entries()) {
        const link = `seed=pace&growth=${growth}&land=${land}&aspect=${aspect}&${REST[(i + j) % 2]}`;
        expect(framesOf(link), link).toBeLessThanOrEqual(LONGEST);
      }
  }, 300_000);

test("so does one of 60,000 attractors or parcels, and a banner from its short side", () => {
  for (const link of [
    "growth=colonize&attractors=60000&meander-rounds=12",
    "growth=colonize&land=rectangle&aspect=3&sides=w&mouths=1&attractors=60000&meander=none&step=0.2",
    "growth=drainage&attractors=60000&meander-rounds=12",
    "growth=drainage&land=rectangle&aspect=3&sides=w&mouths=1&attractors=60000&captures=24&meander=none",
    "growth=brownian&sensitivity=12&meander=none",
    "growth=colonize&attractors=100&land=rectangle&sides=w&aspect=4",
    "growth=drainage&attractors=100&land=rectangle&sides=w&aspect=4",
  ])
    expect(framesOf(link), link).toBeLessThanOrEqual(LONGEST);
}, 300_000);

test("growth is spread over its time, not made in a leap", () => {
  const links = ["drainage", "colonize", "brownian"].flatMap((growth) =>
    ["", "&land=rectangle&aspect=3&sides=w&mouths=1", "&land=archipelago&sea=0.55&aspect=0.25"].map(
      (land) => `growth=${growth}${land}`,
    ),
  );
  for (const link of links) {
    let [last, most] = [0, 0];
    const frames = framesOf(link, [16, 16], (river) => {
      if (river.phase !== "growing") return;
      most = Math.max(most, river.progress - last);
      last = river.progress;
    });
    expect(frames, link).toBeGreaterThan(100);
    expect(most, link).toBeLessThan(0.08);
  }
}, 300_000);

test("the sea is seen rising over the grown tree, frame by frame, until its coasts are those of the map", () => {
  const seen: Uint8Array[] = [];
  framesOf("seed=kauri&attractors=2000&land=island&drowning=0.6&meander=none", [400, 300], (river) => {
    if (river.phase === "drowning" || river.phase === "shaping") {
      const pixels = pixelsOf(river);
      const before = seen.at(-1);
      if (!before || differing(before, pixels) > 0) seen.push(pixels);
    }
  });
  expect(seen.length).toBeGreaterThan(8);
  expect(seen.length).toBeLessThan(16);
  const end = seen.at(-1) as Uint8Array;
  const left = seen.map((pixels) => differing(pixels, end));
  // Each is nearer to the end than the one before.
  expect(left).toEqual(left.toSorted((one, other) => other - one));
  // The last of them is no leap.
  expect(left[0]).toBeGreaterThan(3 * (left.at(-2) ?? 0));
}, 300_000);

test("after 1.2 seconds more than half of what is drawn in the end is there", () => {
  const banner = "land=rectangle&aspect=3&sides=e&mouths=1&attractors=2500";
  // Where the sea rises at the end, all coasts change once more; and lakes come last.
  const links = ["drainage", "colonize"].flatMap((growth) =>
    ["", "&seed=skye", "&aspect=0.7&style=dark", `&${banner}`].map(
      (rest) => `growth=${growth}&drowning=0&lakes=0&labels=none${rest}${rest.includes("style") ? "" : "&style=ink"}`,
    ),
  );
  for (const link of links) {
    const seen: Uint8Array[] = [];
    framesOf(link, [800, 500], (river, frame) => {
      if (frame === 0 || frame === 72) seen.push(pixelsOf(river));
      else if (river.phase === "finished") seen[2] = pixelsOf(river);
    });
    const [ground, then, end] = seen as [Uint8Array, Uint8Array, Uint8Array];
    expect(differing(ground, then) / differing(ground, end), link).toBeGreaterThan(0.5);
  }
}, 300_000);
