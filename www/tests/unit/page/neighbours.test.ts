import { expect, test } from "vitest";
import type { Varied } from "../../../src/apps/page/variations/dials.ts";
import { AROUND, neighboursOf } from "../../../src/apps/page/variations/neighbours.ts";
import { MACROS } from "../../../src/controls/macros.ts";
import { linkText } from "../../../src/engine/link-text.ts";
import { engine } from "../../core.ts";
import { table } from "../../table.ts";

const rows = new Map(table.parameters.map((parameter) => [parameter.key, parameter]));
const NONE: ReadonlyMap<string, string> = new Map();

function map(values: Record<string, string> = {}, others: Partial<Varied> = {}): Varied {
  const { link, values: drawn } = engine.readLink(linkText([["country", "usual"], ...Object.entries(values)]));
  return { link, values: new Map(drawn), idle: NONE, kept: new Set(), ...others };
}

const IN_FRONT = [
  "sea",
  "roughness",
  "attractors",
  "width",
  ...MACROS.flatMap(({ parts }) => parts.map(({ key }) => key)),
];

test("a map has eight neighbours, each of another kind, that change only what stands in front", () => {
  const neighbours = neighboursOf(map(), rows, 0);
  expect(neighbours).toHaveLength(AROUND);
  expect(new Set(neighbours.map(({ values }) => JSON.stringify(values))).size).toBe(AROUND);
  for (const { words, values } of neighbours) {
    expect(words).toMatch(/^[a-z ]+(, [a-z ]+)?$/);
    expect(values.length).toBeGreaterThan(0);
    for (const [key, text] of values) {
      expect(IN_FRONT).toContain(key);
      expect(text).not.toBe(map().values.get(key));
    }
  }
});

test("the words tell which way each value went", () => {
  const sea = (round: number) =>
    neighboursOf(map({ sea: "0.4", land: "continent" }), rows, round).filter(({ words }) => words.includes("sea"));
  const all = [0, 1, 2].flatMap(sea);
  expect(all.length).toBeGreaterThan(3);
  for (const { words, values } of all) {
    const now = Number(new Map(values).get("sea"));
    expect(now > 0.4, words).toBe(words.includes("more sea"));
  }
});

test("the same map has the same neighbours in every style, and others each time that others are asked for", () => {
  const first = neighboursOf(map(), rows, 0);
  expect(neighboursOf(map(), rows, 0)).toEqual(first);
  expect(neighboursOf(map({ style: "night" }), rows, 0)).toEqual(first);
  expect(neighboursOf(map(), rows, 1)).not.toEqual(first);
  expect(neighboursOf(map({ seed: "rimu" }), rows, 0)).not.toEqual(first);
});

test("a sea that suits its land is moved from what it is", () => {
  const seas = [0, 1, 2, 3].flatMap((round) =>
    neighboursOf(map(), rows, round).flatMap(({ values }) => values.filter(([key]) => key === "sea")),
  );
  expect(seas.length).toBeGreaterThan(3);
  for (const [, text] of seas) expect(Number(text)).toBeGreaterThan(0.6);
});

test("what is kept stays, and what has no effect is not moved", () => {
  const kept = new Set(["sea", "meander-rounds", "meander-elsewhere", "meander"]);
  const idle = new Map([["roughness", "there is no coast"]]);
  for (let round = 0; round < 5; round++)
    for (const { words, values } of neighboursOf(map({}, { kept, idle }), rows, round)) {
      for (const [key] of values) expect([...kept, ...idle.keys()]).not.toContain(key);
      expect(words).not.toMatch(/sea|coast|winding/);
    }
});

test("where one dial is left, it alone is moved; where none is, there are no neighbours", () => {
  const keys = IN_FRONT.filter((key) => key !== "width");
  const one = neighboursOf(map({}, { kept: new Set([...keys, "meander"]) }), rows, 0);
  expect(one.length).toBeGreaterThan(4);
  for (const { words, values } of one) {
    expect(words).toMatch(/^(wider|narrower) rivers$/);
    expect(values.map(([key]) => key)).toEqual(["width"]);
  }
  expect(neighboursOf(map({}, { kept: new Set([...keys, "width", "meander"]) }), rows, 0)).toEqual([]);
});

test("values at an end of their range are moved away from it", () => {
  const ends = { roughness: "1", width: "40", attractors: "1000000" };
  for (const { words } of [0, 1, 2].flatMap((round) => neighboursOf(map(ends), rows, round)))
    expect(words).not.toMatch(/wilder|wider|finer/);
});
