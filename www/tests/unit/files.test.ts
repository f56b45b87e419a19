import { expect, test } from "vitest";
import { written } from "../../src/player/files.ts";
import { engine } from "../core.ts";
import { files } from "../files.ts";

const LINK = "seed=kauri&attractors=300&meander-rounds=5";

function grown(steps: number): files.River {
  const river = new files.River(LINK);
  river.advance(steps);
  return river;
}

test("a river becomes the same file however far it has come", async () => {
  const [fresh, ...others] = await Promise.all(
    [0, 10, 100_000].map(async (steps) => (await written(grown(steps), "json")).text()),
  );
  expect(JSON.parse(fresh ?? "").rivers.length).toBeGreaterThan(0);
  expect(others).toEqual([fresh, fresh]);
});

for (const steps of [0, 10, 100_000]) {
  test(`a copy of a river after ${steps} steps goes to the end, and the river stays as it is`, () => {
    const river = new engine.River(LINK);
    river.advance(steps);
    const summary = river.summary();
    const copy = river.copy();
    copy.advance(100_000);
    const whole = new engine.River(LINK);
    whole.advance(100_000);
    expect(copy.summary()).toEqual(whole.summary());
    expect(river.summary()).toEqual(summary);
  });
}

test("a copy goes its own way, and says so", () => {
  const river = new engine.River(LINK);
  river.advance(10);
  const copy = river.copy();
  expect(copy.link).toBe(river.link);
  expect(copy.change("seed=rimu&attractors=100")).toBe("land");
  copy.advance(100_000);
  expect([river.seed, river.phase, copy.seed, copy.phase]).toEqual(["kauri", "growing", "rimu", "finished"]);
});

test("a river is gone once it is a file, and also if it could not be made one", async () => {
  const gone = (river: files.River): unknown => {
    try {
      return river.phase;
    } catch (error) {
      return error;
    }
  };
  const river = grown(0);
  await written(river, "svg");
  expect(gone(river)).toBeInstanceOf(Error);
  const unlucky = grown(0);
  Object.assign(unlucky, {
    svg: () => {
      throw new Error("no room");
    },
  });
  await expect(written(unlucky, "svg")).rejects.toThrow("no room");
  expect(gone(unlucky)).toBeInstanceOf(Error);
});
