import { expect, test } from "vitest";
import { isOwnName, withoutForeignNames } from "../../../src/apps/page/naming/own-names.ts";

const VALUES = new Map([
  ["seed", "kauri"],
  ["country", "coast"],
  ["land", "island"],
  ["names", "12.Silverrun_t.Home"],
]);
/** What the link says: the word has drawn country and land. */
const ASKED = new Map([...VALUES, ["country", "auto"], ["land", "auto"]]);

test.each([
  ["another seed", [["seed", "rimu"]], true],
  ["another land", [["land", "archipelago"]], true],
  [
    "a country of another land",
    [
      ["growth", "drainage"],
      ["land", "valley"],
    ],
    true,
  ],
  [
    "the seed and land that there are",
    [
      ["seed", "kauri"],
      ["land", "island"],
    ],
    false,
  ],
  ["the seed with a capital, in which case does not count", [["seed", "Kauri"]], false],
  ["another country", [["country", "alps"]], true],
  ["the country that is drawn, named", [["country", "coast"]], false],
  [
    "what the word decides, left to it again",
    [
      ["country", "auto"],
      ["land", "auto"],
    ],
    false,
  ],
  ["a pattern, which few countries have", [["pattern", "radial"]], true],
  ["a slider", [["attractors", "900"]], false],
  ["a style", [["style", "night"]], false],
  [
    "another country with names of its own",
    [
      ["seed", "rimu"],
      ["names", "t.Other"],
    ],
    false,
  ],
] as const)("%s: does it let own names go?", (_, changes, letsGo) => {
  const all = withoutForeignNames([...changes], { asked: ASKED, values: VALUES });
  expect(all).toEqual(letsGo ? [...changes, ["names", ""]] : changes);
});

test("where there are no own names there is nothing to let go", () => {
  const values = new Map([["seed", "kauri"]]);
  expect(withoutForeignNames([["seed", "rimu"]], { asked: values, values })).toEqual([["seed", "rimu"]]);
});

test("a name is one's own by its whole mark", () => {
  expect(isOwnName("12.Silverrun_t.2.Home", "12")).toBe(true);
  expect(isOwnName("12.Silverrun_t.2.Home", "t")).toBe(true);
  expect(isOwnName("12.Silverrun_t.2.Home", "2")).toBe(false);
  expect(isOwnName("", "t")).toBe(false);
});

test("where the country is named, a pattern moves rivers on it at most", () => {
  const asked = new Map([...ASKED, ["country", "coast"]]);
  expect(withoutForeignNames([["pattern", "radial"]], { asked, values: VALUES })).toEqual([["pattern", "radial"]]);
});
