import { expect, test } from "vitest";
import { progressOf } from "../../src/player/progress.ts";
import { engine } from "../core.ts";

test("progress goes from 0 to 1 through every phase, and never back", () => {
  const river = new engine.River(
    "country=usual&seed=rimu&land=island&drowning=0.4&attractors=2000&style=atlas&labels=none",
  );
  const shares = [progressOf(river)];
  const phases = new Set([river.phase]);
  while (river.advance(1)) {
    shares.push(progressOf(river));
    phases.add(river.phase);
  }
  shares.push(progressOf(river));
  expect([...phases]).toEqual(["growing", "drowning", "shaping", "meandering", "relief"]);
  expect(shares[0]).toBe(0);
  expect(shares.at(-1)).toBe(1);
  expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  river.free();
});
