import { expect, it } from "vitest";
import { landBoundsOf } from "../../src/apps/page-worker/land-bounds.ts";
import { engine } from "../core.ts";

it("bounds the land of a river, without its islets", () => {
  const river = {
    lengths: () => ({ width: 1000, height: 500 }),
    coasts: () => [
      [200, 100, 600, 150, 400, 300],
      [700, 200, 800, 250, 700, 250],
      // An islet.
      [950, 450, 990, 460, 950, 470],
    ],
  };
  expect(landBoundsOf(river as never)).toEqual({ left: 0.2, top: 0.2, right: 0.8, bottom: 0.6 });
  expect(landBoundsOf({ ...river, coasts: () => [] } as never)).toBeUndefined();
});

it("bounds the land that the engine makes", () => {
  const river = new engine.River("country=usual&seed=kauri&attractors=300");
  const bounds = landBoundsOf(river);
  if (!bounds) throw new Error("no land");
  const { left, top, right, bottom } = bounds;
  // An island has sea on all sides, and is most of its map.
  for (const gap of [left, top, 1 - right, 1 - bottom]) {
    expect(gap).toBeGreaterThan(0);
    expect(gap).toBeLessThan(0.4);
  }
  river.free();
  const all = new engine.River("land=rectangle&attractors=300");
  expect(landBoundsOf(all)).toBeUndefined();
  all.free();
});
