import { expect, test } from "vitest";
import { fileOf } from "../../src/player/formats.ts";
import { full, memory } from "../full.ts";

const LINK = "seed=kauri&attractors=300&meander-rounds=5";
const core = { engine: full, memory };

function grown(steps: number): full.River {
  const river = new full.River(LINK);
  river.advance(steps);
  return river;
}

const json = async (river: full.River): Promise<object> => JSON.parse(await (await fileOf(river, core, "json")).text());

for (const steps of [0, 10, 100_000]) {
  test(`a copy of a river after ${steps} steps becomes the finished file, and the river stays as it is`, async () => {
    const river = grown(steps);
    const summary = river.summary();
    expect(await json(river.copy())).toEqual(await json(grown(0)));
    expect(river.summary()).toEqual(summary);
  });
}

test("a copy goes its own way, and says so", () => {
  const river = grown(10);
  const copy = river.copy();
  expect(copy.link).toBe(river.link);
  expect(copy.change("seed=rimu&attractors=100")).toBe("land");
  copy.advance(100_000);
  expect([river.seed, river.phase, copy.seed, copy.phase]).toEqual(["kauri", "growing", "rimu", "finished"]);
});

test("a river is gone once it is a file, and also if it could not be made one", async () => {
  const gone = (river: full.River): unknown => {
    try {
      return river.phase;
    } catch (error) {
      return error;
    }
  };
  const river = grown(0);
  await fileOf(river, core, "svg");
  expect(gone(river)).toBeInstanceOf(Error);
  const unlucky = grown(0);
  Object.assign(unlucky, {
    svg: () => {
      throw new Error("no room");
    },
  });
  await expect(fileOf(unlucky, core, "svg")).rejects.toThrow("no room");
  expect(gone(unlucky)).toBeInstanceOf(Error);
});
