import { expect, test } from "vitest";
import { isOwnName, withoutForeignNames } from "../../../src/apps/page/naming/own-names.ts";

const VALUES = new Map([
  ["seed", "kauri"],
  ["land", "island"],
  ["names", "12.Silverrun_t.Home"],
]);

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
  const all = withoutForeignNames([...changes], VALUES);
  expect(all).toEqual(letsGo ? [...changes, ["names", ""]] : changes);
});

test("where there are no own names there is nothing to let go", () => {
  expect(withoutForeignNames([["seed", "rimu"]], new Map([["seed", "kauri"]]))).toEqual([["seed", "rimu"]]);
});

test("a name is one's own by its whole mark", () => {
  expect(isOwnName("12.Silverrun_t.2.Home", "12")).toBe(true);
  expect(isOwnName("12.Silverrun_t.2.Home", "t")).toBe(true);
  expect(isOwnName("12.Silverrun_t.2.Home", "2")).toBe(false);
  expect(isOwnName("", "t")).toBe(false);
});
