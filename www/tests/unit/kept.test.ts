import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, expect, test } from "vitest";
import { Kept } from "../../build/gallery/kept.ts";

const FILE = new Uint8Array([1, 2, 3]);
let cache = "";

beforeEach(() => {
  cache = mkdtempSync(join(tmpdir(), "riverseed-kept-"));
});
afterEach(() => rmSync(cache, { recursive: true }));

/** Returns the paths of the files that are kept. */
function places(): string[] {
  const all = readdirSync(cache, { recursive: true, withFileTypes: true });
  return all.filter((one) => one.isFile()).map((one) => join(one.parentPath, one.name));
}

test("a later build finds what an earlier one has drawn", () => {
  new Kept(cache, ["engine"]).keep(["seed=a", "wide"], FILE);
  expect(new Kept(cache, ["engine"]).file(["seed=a", "wide"])).toEqual(Buffer.from(FILE));
});

test("another engine, other code, another link or size find nothing, nor what only joins to the same text", () => {
  new Kept(cache, ["engine", "code"]).keep(["seed=a", "wide"], FILE);
  for (const makers of [["engine 2", "code"], ["engine", "code 2"], ["engine"], ["enginec", "ode"]])
    expect(new Kept(cache, makers).file(["seed=a", "wide"]), `${makers}`).toBeUndefined();
  for (const parts of [["seed=b", "wide"], ["seed=a", "tall"], ["seed=a"], ["seed=aw", "ide"]])
    expect(new Kept(cache, ["engine", "code"]).file(parts), `${parts}`).toBeUndefined();
});

test("a file that is damaged, cut short or empty is drawn anew", () => {
  const kept = new Kept(cache, ["engine"]);
  kept.keep(["seed=a"], FILE);
  const [place = ""] = places();
  const sealed = readFileSync(place);
  const flipped = Buffer.from(sealed);
  flipped[flipped.length - 1] = 9;
  for (const damaged of [flipped, sealed.subarray(0, -1), sealed.subarray(0, 5), Buffer.of()]) {
    writeFileSync(place, damaged);
    expect(kept.file(["seed=a"])).toBeUndefined();
  }
  kept.keep(["seed=a"], FILE);
  expect(kept.file(["seed=a"])).toEqual(Buffer.from(FILE));
});

test("without a cache nothing is kept", () => {
  const kept = new Kept(undefined, ["engine"]);
  kept.keep(["seed=a"], FILE);
  expect(kept.file(["seed=a"])).toBeUndefined();
});

test("what engines of long ago have drawn does not stay for ever", () => {
  for (let i = 0; i < 6; i++) new Kept(cache, [`engine ${i}`]).keep(["seed=a"], FILE);
  expect(places()).toHaveLength(4);
  expect(new Kept(cache, ["engine 5"]).file(["seed=a"])).toBeDefined();
});
