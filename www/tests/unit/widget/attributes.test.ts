import { expect, test } from "vitest";
import { ASPECT, aspectOf, linkOf, linkToReadOf, OBSERVED, speedOf } from "../../../src/apps/widget/attributes.ts";
import { RiverSeed } from "../../../src/apps/widget/element.ts";
import { attributeOf, NUMBERS, TEXTS } from "../../../src/engine/attribute-names.ts";
import { engine, parameter } from "../../core.ts";
import { MANGLED } from "../../mangled.ts";
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
});

/** The link of what the core makes of an element. */
function read(attributes: Record<string, string>): string {
  const { text, options } = linkToReadOf(element({ theme: "light", ...attributes }));
  return engine.readLink(text, options).link;
}

test("a recipe or a seed that is an address is its map, with the other attributes in place of what it says", () => {
  const address = "https://rivers.example/?seed=rimu&land=valley";
  const rimu = "seed=rimu&edition=1&land=valley";
  expect([read({ recipe: address }), read({ seed: address }), read({ seed: `<${address}>` })]).toEqual([
    rimu,
    rimu,
    rimu,
  ]);
  expect([read({ recipe: "#seed=rimu&amp;land=valley" }), read({ recipe: "curl=1", seed: address })]).toEqual([
    rimu,
    rimu,
  ]);
  expect(read({ recipe: address, seed: "a?b", land: "island" })).toBe(read({ seed: "a?b", land: "island" }));
  expect(read({ recipe: "kauri" })).toBe("seed=kauri&edition=1");
  expect(read({ seed: "seed=a&land=valley" })).toBe("seed=seed%3Da%26land%3Dvalley&edition=1");
  expect(read({ recipe: "seed=x&seed=y&curl=1", seed: "z", curl: "" })).toBe(read({ seed: "z" }));
});

test("what is a link for certain is handed over as a link, which all engines read, and all else with its attributes apart", () => {
  const isApart = (attributes: Record<string, string>): boolean =>
    "values" in linkToReadOf(element({ theme: "light", ...attributes })).options;
  for (const recipe of [
    "",
    "seed=kauri&edition=1",
    "seed=a%26b&names=12.Silver+Water&curl=0.5",
    "land=drawn&outline=.AA_A",
  ])
    for (const seed of [{}, { seed: "a & b = c" }]) expect(isApart({ recipe, ...seed }), recipe).toBe(false);
  for (const [text] of MANGLED.filter(([, isDamaged]) => isDamaged)) {
    expect(isApart({ recipe: text }), text).toBe(true);
    expect(read({ recipe: text }), text).toBe("seed=rimu&edition=1&land=valley");
  }
  for (const recipe of ["kauri", "?seed=a", "land=valley+", "land=valley."])
    expect(isApart({ recipe }), recipe).toBe(true);
  expect([isApart({ seed: "https://a.example/?seed=b" }), isApart({ seed: "Why?" })]).toEqual([true, true]);
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
