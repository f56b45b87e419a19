import { expect, test } from "vitest";
import { isAdjustable } from "../../src/controls/controls.ts";
import { engine, parameter, pictureOf } from "../core.ts";
import { table } from "../table.ts";
import { isSecondTier, ofTier } from "../tier.ts";

/** What decides whether others do something; coarse and soon done, since every value of every key is drawn. */
const PLAIN =
  "country=usual&growth=colonize&valleys=0&simplify=60&aspect=1.5&land=rectangle&sea=0.5&roughness=0.5&curl=0&trim=20&width=14&great-rivers=1&style=ink&labels=none";
/** Long enough for some side branches to be about as long. */
const COARSE = `${PLAIN.replace("trim=20", "trim=60")}&attractors=100&sensitivity=64&mouths=9&meander-rounds=10`;
const OUTLINE = engine.outlineOf([Float32Array.of(0.2, 0.2, 0.8, 0.25, 0.75, 0.8, 0.2, 0.7)], [], []);
const lands = parameter("land").choices?.map(({ value }) => `land=${value}`) ?? [];
const growths = parameter("growth").choices?.map(({ value }) => `growth=${value}`) ?? [];
/** Valleys and hard ground lie many parcels apart. */
const FINE = "attractors=1000&trim=40&valleys=0.5";
const styles = parameter("style").choices?.map(({ value }) => `style=${value}`) ?? [];
const meanders = parameter("meander").choices?.map(({ value }) => `meander=${value}`) ?? [];
const recipes = [
  ...[...lands, `land=drawn&outline=${OUTLINE}`].flatMap((land) =>
    growths.map((growth) => `${land}&${growth}${growth.endsWith("brownian") ? "" : `&${FINE}`}`),
  ),
  ...styles,
  ...meanders,
  "curl=0.6",
  `growth=drainage&pattern=trellis&${FINE}`,
  `growth=drainage&pattern=radial&${FINE}`,
  "land=island&deltas=0.5",
  "meander-rounds=0",
  "meander-strength=0",
  "great-rivers=0",
  "great-rivers=0&meander-elsewhere=0",
  "style=skeleton&meander=none",
  "style=skeleton&meander-rounds=0",
  "courses=grown",
  "courses=grown&style=skeleton",
].map((link) => merged(COARSE, link));

/** What these do depends on whether two lines come near each other, a side branch is about as long as the trim, or a valley can hold a lake, or the sea a delta. */
const BY_CHANCE = ["neck", "oxbows", "clearance", "trim-variation", "lakes", "deltas", "waves"];
/** What may change nothing although it could: how rivers would meander can be chosen before they do; without strength they only smooth. */
function maySame(link: string): string[] {
  return [...sameByChance(link), "country"]; // who chooses another country keeps what these links name
}

function sameByChance(link: string): string[] {
  if (link.includes("meander-rounds=0")) return [...BY_CHANCE, "meander"];
  if (link.includes("meander-strength=0"))
    return [...BY_CHANCE, "meander-elsewhere", "great-rivers", "flat-share", "taper"];
  return BY_CHANCE;
}

/** Many rivers that meander for long. */
const CLOSE = merged(
  PLAIN,
  "mouths=3&attractors=500&great-rivers=16&meander-elsewhere=1&meander-rounds=120&meander-strength=1",
);

/** A coast with great rivers, which have sediment. */
const COAST = merged(PLAIN, "land=island&attractors=800&width=24&deltas=0.7&waves=0.5");

const keys = table.parameters
  .filter(isAdjustable)
  // What annotates a map shows on larger maps than these, or in files only: `labels.test.ts` and tests of the core look at it.
  .filter(({ stage }) => stage !== "name")
  .map(({ key }) => key);

/** The ends of a key's range, or all its choices; the number of attractors within reason. */
function textsOf(key: string): string[] {
  const { kind, min, max, choices } = parameter(key);
  // Of a coast that looks one way, all lies on these or on those sides of its middle; but not all to the west.
  if (kind === "sides") return ["n", "ew", "w"];
  if (choices) return choices.map(({ value }) => value);
  return [String(min), String(Math.min(max ?? 0, 1200))];
}

/** A link with the values of another one over its own. */
function merged(link: string, over: string): string {
  const query = new URLSearchParams(link);
  for (const [key, text] of new URLSearchParams(over)) query.set(key, text);
  return query.toString();
}

/** The keys that are said to do nothing, and why. */
function idleIn(link: string): ReadonlyMap<string, string> {
  return new Map(engine.readLink(link).idle);
}

const pictures = new Map<string, string>();

/** The pixels, and all that is said of them. */
function drawn(link: string): string {
  const found = pictures.get(link) ?? JSON.stringify(pictureOf(link, 240, 160));
  pictures.set(link, found);
  return found;
}

/** Every fourth recipe shows both, and the others are of the second tier. */
const tried = ofTier(recipes, 4);

for (const link of tried) {
  test(`what is idle changes nothing: ${link.slice(-100)}`, () => {
    const idle = idleIn(link);
    for (const key of keys.filter((key) => idle.has(key))) {
      for (const text of textsOf(key))
        expect(drawn(merged(link, `${key}=${text}`)), `${key}=${text}`).toBe(drawn(link));
    }
  }, 60_000);
}

for (const link of tried) {
  test(`what is not idle changes something: ${link.slice(-100)}`, () => {
    const idle = idleIn(link);
    const active = keys.filter((key) => !idle.has(key));
    const isSame = (key: string) => textsOf(key).every((text) => drawn(merged(link, `${key}=${text}`)) === drawn(link));
    expect(active.filter((key) => !maySame(link).includes(key) && isSame(key))).toEqual([]);
  }, 60_000);
}

for (const key of BY_CHANCE) {
  const where = key === "deltas" || key === "waves" ? COAST : CLOSE;
  test.skipIf(isSecondTier)(
    `${key} changes something where lines come near each other`,
    () => {
      const [least, most] = textsOf(key).map((text) => drawn(merged(where, `${key}=${text}`)));
      expect(least).not.toBe(most);
    },
    60_000,
  );
}

test.skipIf(isSecondTier)("every key that can be idle is so in some recipe, and does something in another", () => {
  for (const key of keys) {
    expect(
      recipes.some((link) => !idleIn(link).has(key)),
      key,
    ).toBe(true);
  }
  for (const key of [
    "sea",
    "roughness",
    "mouth-spacing",
    "sides",
    "sensitivity",
    "attractors",
    "curl",
    "stretch",
    "simplify",
    "width",
    "bank-variation",
    "meander",
    "flat-share",
    "neck",
  ]) {
    expect(
      recipes.some((link) => idleIn(link).has(key)),
      key,
    ).toBe(true);
  }
});
