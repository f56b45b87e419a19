import { createHash } from "node:crypto";
import { expect, it } from "vitest";
import { finishedPicture, type Thumbnail, thumbnails } from "../../src/player/thumbnails.ts";
import { engine, memory, pictureOf } from "../core.ts";

const LINK = "country=usual&seed=rimu&attractors=300&labels=none";
const SIZE = { width: 112, height: 64 };
const STYLES = ["atlas", "ink", "basins", "past-courses", "night"];

/** A finished river, and how often it was given back. */
function finished(text: string): { river: InstanceType<typeof engine.River>; freed: () => number } {
  const river = new engine.River(text);
  while (river.advance(1000));
  const free = river.free.bind(river);
  let count = 0;
  river.free = () => {
    count++;
    free();
  };
  return { river, freed: () => count };
}

it("makes each small picture as the engine draws that map in that style, bare of labels", async () => {
  const { river, freed } = finished(`${LINK.replace("none", "many")}&woods=0.5&style=survey`);
  const made: Thumbnail[] = [];
  for await (const one of thumbnails(river, memory, STYLES, SIZE, async () => true)) made.push(one);
  expect(made.map(({ style }) => style)).toEqual(STYLES);
  for (const { style, width, height, pixels } of made) {
    const sha256 = createHash("sha256").update(pixels).digest("hex");
    expect(sha256, style).toBe(pictureOf(`${LINK}&style=${style}`, width, height).sha256);
  }
  expect(freed()).toBe(1);
});

it("stops when it is not to go on, and gives the river back", async () => {
  const { river, freed } = finished(LINK);
  let pauses = 0;
  const made: string[] = [];
  for await (const { style } of thumbnails(river, memory, STYLES, SIZE, async () => ++pauses < 3)) made.push(style);
  expect(made.length).toBeLessThan(STYLES.length);
  expect(freed()).toBe(1);
});

/** A finished river that throws when it is changed to a style. */
function failingAt(style: string, thrown: Error): ReturnType<typeof finished> {
  const made = finished(LINK);
  const change = made.river.change.bind(made.river);
  made.river.change = (link, ...more) => {
    if (link.includes(`style=${style}`)) throw thrown;
    return change(link, ...more);
  };
  return made;
}

it("leaves out a style that fails, and makes the others", async () => {
  const { river, freed } = failingAt("basins", Object.assign(new Error("no room"), { code: "no-memory" }));
  const made: string[] = [];
  for await (const { style } of thumbnails(river, memory, STYLES, SIZE, async () => true)) made.push(style);
  expect(made).toEqual(STYLES.filter((style) => style !== "basins"));
  expect(freed()).toBe(1);
});

it("draws another map from a river as the engine draws that map, bare of labels", async () => {
  const { river, freed } = finished(LINK);
  const other = LINK.replace("attractors=300", "attractors=500&width=9");
  river.change(`${other.replace("none", "many")}&woods=0.5`);
  const made = await finishedPicture(river, memory, SIZE, async () => true);
  const sha256 = createHash("sha256")
    .update(made?.pixels ?? "")
    .digest("hex");
  expect(sha256).toBe(pictureOf(other, SIZE.width, SIZE.height).sha256);
  expect(freed()).toBe(1);
});

it("draws no other map that is not wanted any more, and gives the river back", async () => {
  const { river, freed } = finished(LINK);
  river.change(LINK.replace("attractors=300", "attractors=30000"));
  expect(await finishedPicture(river, memory, SIZE, async () => false)).toBeUndefined();
  expect(freed()).toBe(1);
});

it("passes on that the engine has stopped, and asks nothing more of the river", async () => {
  const { river, freed } = failingAt("basins", new WebAssembly.RuntimeError("unreachable"));
  const made: string[] = [];
  const all = async (): Promise<void> => {
    for await (const { style } of thumbnails(river, memory, STYLES, SIZE, async () => true)) made.push(style);
  };
  await expect(all()).rejects.toThrow("unreachable");
  expect(made).toEqual(["atlas", "ink"]);
  expect(freed()).toBe(0);
});
