import { expect, test } from "vitest";
import { courseOf, measuresOf, titleOf } from "../../../src/apps/page/look-inside/river-words.ts";
import type { PointedRiver } from "../../../src/apps/page-worker/protocol.ts";

const RIVER: PointedRiver = {
  link: "",
  size: [1000, 1000],
  mark: "7",
  name: "Ash Beck",
  order: 4,
  orderHere: 4,
  length: 312.4,
  share: 0.184,
  area: 101_700,
  into: [],
  endsIn: "sea",
  mouths: 1,
  x: 0,
  y: 0,
  way: "",
  basin: "",
};

test("a river is told by its order, its length and what it drains", () => {
  expect(measuresOf(RIVER)).toBe("Order 4 · 312 km long · drains 18 % of the land, 100,000 km²");
  const small = { ...RIVER, orderHere: 1, share: 0.004, area: 0 };
  expect(measuresOf(small)).toBe("Order 4 (1 here) · 312 km long · drains less than 1 % of the land, 0 km²");
  const short = { ...RIVER, length: 2.44, area: 3.26 };
  expect(measuresOf(short)).toBe("Order 4 · 2.4 km long · drains 18 % of the land, 3.3 km²");
});

test("where its water goes is told by name, and names with an article keep one", () => {
  const into = (...into: string[]): string => courseOf({ ...RIVER, into });
  expect(into()).toBe("Flows into the sea");
  expect(into("The Lamprey")).toBe("Flows into the Lamprey, then the sea");
  expect(into("", "Ash")).toBe("Flows into a greater river, then the Ash, then the sea");
  expect(into("A", "B", "C", "D")).toBe("Flows into the A, then the B, then the C, and on to the sea");
  expect(courseOf({ ...RIVER, endsIn: "lake" })).toBe("Flows into the lake, which has no outlet");
  expect(courseOf({ ...RIVER, mouths: 7 })).toBe("Flows into the sea through 7 mouths");
});

test("a river whose name was taken away is called so", () => {
  expect([titleOf(RIVER), titleOf({ ...RIVER, name: "" })]).toEqual(["Ash Beck", "A river without a name"]);
});

test("a lake is told by its name, its size, and the river that runs out of it", () => {
  const lake = { mark: "l1", name: "Lake Dellen", area: 12.3, depth: 39.6, level: 1210.2 };
  const river = { ...RIVER, lake };
  expect(titleOf(river)).toBe("Lake Dellen");
  expect(measuresOf(river)).toBe("12 km² · up to 40 m deep · 1,210 m above the sea");
  expect(courseOf(river)).toBe("The Ash Beck runs out of it");
  expect(titleOf({ ...river, lake: { ...lake, name: "" } })).toBe("A lake without a name");
  expect(courseOf({ ...river, name: "" })).toBe("A river runs out of it");
});
