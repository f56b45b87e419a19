import { expect, test } from "vitest";
import { ASPECT, aspectOf, linkOf, OBSERVED, speedOf } from "../../../src/apps/widget/attributes.ts";
import { RiverSeed } from "../../../src/apps/widget/element.ts";
import { attributeOf, NUMBERS, TEXTS } from "../../../src/engine/attribute-names.ts";
import { engine, parameter } from "../../core.ts";
import { table } from "../../table.ts";

/** As much of an element as is asked for its attributes. */
function element(attributes: Record<string, string>): Element {
  return { getAttribute: (name: string) => attributes[name] ?? null } as Element;
}

test("the attributes are the table's keys, each of its kind", () => {
  const isNumber = ({ kind }: { kind: string }): boolean => kind === "integer" || kind === "number";
  const keys = (isIt: (row: { kind: string }) => boolean): string[] =>
    table.parameters.filter(isIt).map(({ key }) => key);
  expect(NUMBERS.toSorted()).toEqual(keys(isNumber).toSorted());
  expect(TEXTS.toSorted()).toEqual(keys((row) => !isNumber(row)).toSorted());
});

test("the shape before the engine is there is the table's", () => {
  const { min, max, default: usual } = parameter("aspect");
  expect(ASPECT).toEqual({ min, max, default: Number(usual) });
});

test("no attribute means something else in HTML, but for those that are prefixed", () => {
  expect(
    OBSERVED.filter((name) => ["style", "width", "class", "id", "title", "slot", "hidden", "animate"].includes(name)),
  ).toEqual([]);
  expect(attributeOf("style")).toBe("river-style");
  expect(attributeOf("curl")).toBe("curl");
});

test("what an element asks for is its recipe, with its attributes in place of what that says", () => {
  expect(linkOf(element({}))).toBe("");
  expect(linkOf(element({ seed: "a&b=c", "river-style": "atlas", "meander-rounds": "3" }))).toBe(
    "meander-rounds=3&seed=a%26b%3Dc&style=atlas",
  );
  expect(linkOf(element({ recipe: "?seed=x&seed=y&curl=1&preset=curl", seed: "z", curl: "" }))).toBe(
    "seed=z&curl=&preset=curl",
  );
  expect(linkOf(element({ recipe: "#seed=x" }))).toBe("seed=x");
});

for (const text of ["aspect=2.5", "aspect=-3", "aspect=99", "aspect=wide", "aspect=", "aspect=%202", ""]) {
  test(`the box has the shape that the core reads: ?${text}`, () => {
    const values = new Map(engine.readLink(text).values);
    expect(aspectOf(text)).toBe(Number(values.get("aspect")));
  });
}

test.each([
  ["0.5", 0.5],
  [" 2 ", 2],
  ["1e1", 8],
  ["0", 0.25],
  ["-3", 0.25],
  ["Infinity", 1],
  ["fast", 1],
  ["", 1],
])("a speed of %j is %d times the ordinary one", (speed, times) => {
  expect(speedOf(element({ speed }))).toBe(times);
});

test("without the attribute the speed is the ordinary one, and it is no part of the recipe", () => {
  expect(speedOf(element({}))).toBe(1);
  expect(linkOf(element({ speed: "2" }))).toBe("");
});

test("the class can be imported where there is no browser", () => {
  expect(RiverSeed.observedAttributes).toContain("seed");
});
