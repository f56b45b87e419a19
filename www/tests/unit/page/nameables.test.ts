import { expect, test } from "vitest";
import { type Known, nameablesAt, type Placed, placedOn } from "../../../src/apps/page-worker/nameables.ts";
import type { LabelFacts, RiverFacts } from "../../../src/engine/types.ts";
import { engine } from "../../whole.ts";

/** A river at 0.5, 0.5, whatever is asked for within reach of it. */
function riverAt(x: number, y: number, reach: number): RiverFacts | undefined {
  return Math.hypot(x - 0.5, y - 0.5) * 1000 <= reach ? ({ mark: 7, x: 0.5, y: 0.5 } as RiverFacts) : undefined;
}

function place(mark: string, kind: Placed["kind"], line: number[], size = 0.02): Placed {
  return { mark, kind, name: `Name of ${mark}`, line, size };
}

const KNOWN: Known = {
  inspector: { at: riverAt, of: () => riverAt(0.5, 0.5, 1), areaAt: (x) => (x < 0.9 ? "i0" : "s9") },
  size: [1000, 1000],
  names: new Map([
    ["7", "The Long Grey"],
    ["t", "Ardenmoor"],
  ]),
  places: [
    place("i0", "land", [0.4, 0.4, 0.6, 0.4]),
    place("s9", "sea", [0.95, 0.5]),
    place("c1", "cape", [0.5, 0.515]),
    place("b2", "bay", [0.7, 0.5], 0.1),
    place("h3", "range", [0.49, 0.5, 0.51, 0.5]),
  ],
};
const LABELS: LabelFacts[] = [
  { mark: "", text: "Name of s9", em: 0.02, line: new Float32Array([0.2, 0.2, 0.3, 0.2]) },
  { mark: "t", text: "Ardenmoor", em: 0.05, line: new Float32Array([0.1, 0.1]) },
];

function marksAt(x: number, y: number, hasLabels = true, reach = 0.02): string[] {
  return nameablesAt({ x, y, reach, hasLabels }, KNOWN, LABELS).map(({ mark }) => mark);
}

test("of a river and a place the nearer comes first, and the other stays reachable", () => {
  expect(marksAt(0.5, 0.505)).toEqual(["7", "c1", "h3", "i0"]);
  expect(marksAt(0.5, 0.512)).toEqual(["c1", "7", "h3", "i0"]);
});

test("a bay is hit anywhere in it, a land or sea wherever nothing else is", () => {
  expect(marksAt(0.74, 0.5)).toEqual(["b2", "i0"]);
  expect(marksAt(0.76, 0.5)).toEqual(["i0"]);
  expect(marksAt(0.97, 0.1)).toEqual(["s9"]);
});

test("a name is hit by its letters, if they are shown", () => {
  expect(marksAt(0.2, 0.205)).toEqual(["s9", "i0"]);
  // Between letters far apart there is what lies there.
  expect(marksAt(0.25, 0.2)).toEqual(["i0"]);
  expect(marksAt(0.2, 0.205, false)).toEqual(["i0"]);
  expect(marksAt(0.11, 0.1)).toEqual(["t", "i0"]);
});

test("an area whose name is on the picture is shown by its letters, which no line strikes out", () => {
  const sea = { mark: "s9", line: LABELS[0]?.line, em: 0.02 };
  expect(nameablesAt({ mark: "s9" }, KNOWN, LABELS)).toMatchObject([sea]);
  expect(nameablesAt({ x: 0.97, y: 0.1, reach: 0.02, hasLabels: true }, KNOWN, LABELS)).toMatchObject([sea]);
  const [unnamed] = nameablesAt({ x: 0.97, y: 0.1, reach: 0.02, hasLabels: false }, KNOWN, LABELS);
  expect(unnamed?.line).toEqual([0.95, 0.5]);
  expect(unnamed).not.toHaveProperty("em");
});

test("a mark is the thing itself, the map's too", () => {
  const of = (mark: string) => nameablesAt({ mark }, KNOWN, LABELS)[0];
  expect(of("7")).toMatchObject({ kind: "river", name: "The Long Grey", line: [0.5, 0.5] });
  expect(of("b2")).toMatchObject({ kind: "bay", name: "Name of b2" });
  expect(of("t")).toMatchObject({ kind: "map", name: "Ardenmoor" });
  expect(of("h99")).toBe(undefined);
});

test("places of a map have the marks and names of the list, and lie in the area that has their mark", () => {
  const river = new engine.River("seed=kauri&land=island&attractors=400&meander-rounds=2&names=i0.Thessaly");
  while (river.advance(1000));
  while (river.raiseRelief());
  const inspector = river.inspector();
  if (!inspector) throw new Error("no inspector");
  const places = placedOn(inspector, new Map(inspector.names()));
  expect(places.find(({ kind }) => kind === "land")?.name).toBe("Thessaly");
  const listed = river.greatest(12).map(({ mark }) => mark);
  expect(places.map(({ mark }) => mark)).toEqual(listed.filter((mark) => /^[sliabcnhm]\d/.test(mark)));
  for (const { kind, mark, line } of places) {
    expect(line.length).toBeGreaterThanOrEqual(2);
    if (kind === "sea" || kind === "island") expect(inspector.areaAt(line[0] ?? 0, line[1] ?? 0)).toBe(mark);
  }
  expect(inspector.areaAt(-0.1, 0.5)).toBe(undefined);
  inspector.free();
});
