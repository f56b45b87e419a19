import { expect, test } from "vitest";
import { isAdjustable } from "../../src/controls.ts";
import { idleReason } from "../../src/idle.ts";
import { engine, parameter, pictureOf } from "../core.ts";

/** What decides whether others do something; coarse, since every value of every key is drawn. */
const COARSE = "attractors=100&sensitivity=64&mouths=24";
const OUTLINE = engine.outlineOf([Float32Array.of(0.2, 0.2, 0.8, 0.25, 0.75, 0.8, 0.2, 0.7)], []);
const lands = parameter("land").choices?.map(({ value }) => `land=${value}`) ?? [];
const growths = parameter("growth").choices?.map(({ value }) => `growth=${value}`) ?? [];
const styles = parameter("style").choices?.map(({ value }) => `style=${value}`) ?? [];
const recipes = [
  ...[...lands, `land=drawn&outline=${OUTLINE}`].flatMap((land) => growths.map((growth) => `${land}&${growth}`)),
  ...styles,
  "curl=0.6",
].map((link) => `${COARSE}&${link}`);

const keys = engine
  .parameters()
  .filter(isAdjustable)
  .map(({ key }) => key);

/** The ends of a key's range, or all its choices; the number of attractors within reason. */
function textsOf(key: string): string[] {
  const { kind, min, max, choices } = parameter(key);
  if (kind === "sides") return ["n", "ew"];
  if (choices) return choices.map(({ value }) => value);
  return [String(min), String(Math.min(max ?? 0, 1000))];
}

function valuesOf(link: string): Map<string, string> {
  return new Map(engine.readLink(link).values);
}

function withValue(link: string, key: string, text: string): string {
  const query = new URLSearchParams(link);
  query.set(key, text);
  return query.toString();
}

const pictures = new Map<string, string>();

/** The pixels, and all that is said of them. */
function drawn(link: string): string {
  const found = pictures.get(link) ?? JSON.stringify(pictureOf(link, 240, 160));
  pictures.set(link, found);
  return found;
}

for (const link of recipes) {
  test(`what is idle changes nothing: ${link.slice(0, 80)}`, () => {
    const idle = keys.filter((key) => idleReason(key, valuesOf(link)) !== undefined);
    for (const key of idle) {
      for (const text of textsOf(key)) expect(drawn(withValue(link, key, text)), `${key}=${text}`).toBe(drawn(link));
    }
  }, 60_000);
}

test("what is not idle changes something, on every land, however it grows", () => {
  const unchanged = recipes.flatMap((link) => {
    const active = keys.filter((key) => idleReason(key, valuesOf(link)) === undefined);
    const isSame = (key: string) => textsOf(key).every((text) => drawn(withValue(link, key, text)) === drawn(link));
    return active.filter(isSame).map((key) => `${key} in ${link}`);
  });
  expect(unchanged).toEqual([]);
}, 60_000);

test("every key that can be idle is so in some recipe, and does something in another", () => {
  for (const key of keys) {
    expect(
      recipes.some((link) => idleReason(key, valuesOf(link)) === undefined),
      key,
    ).toBe(true);
  }
  for (const key of ["sea", "rough", "apart", "sides", "sensitivity", "attractors", "curl", "stretch", "width"]) {
    expect(
      recipes.some((link) => idleReason(key, valuesOf(link)) !== undefined),
      key,
    ).toBe(true);
  }
});
