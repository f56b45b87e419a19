import { expect, test } from "vitest";
import { asText, kept, summed, told } from "../../src/apps/page/panel/measures.ts";
import type { Measure } from "../../src/engine/types.ts";
import { engine } from "../core.ts";

const NATURE = { median: 1.32, least: 1.21, most: 1.54, source: "11 river basins" };
const SINUOSITY: Measure = {
  name: "sinuosity",
  help: "length over line",
  unit: "",
  places: 2,
  value: 1.3,
  nature: NATURE,
};

function verdictOf(value: number): string | undefined {
  return told([{ ...SINUOSITY, value }])[0]?.verdict;
}

test("a value is judged by nature's range, as it is written", () => {
  expect(verdictOf(1.3)).toBe("as in nature");
  expect(verdictOf(1.206)).toBe("as in nature");
  expect(verdictOf(1.2)).toBe("straighter than in nature");
  expect(verdictOf(1.55)).toBe("more winding than in nature");
});

test("its bar has nature's range in the middle, and ends where values lie far off", () => {
  const barOf = (value: number) => told([{ ...SINUOSITY, value }])[0]?.bar?.value;
  expect(barOf(1.21)).toBeCloseTo(1 / 3);
  expect(barOf(1.54)).toBeCloseTo(2 / 3);
  expect(barOf(9)).toBe(1);
  expect(barOf(0)).toBe(0);
});

test("a sentence sums them up, without a score", () => {
  expect(summed(told([SINUOSITY]))).toBe("All that can be compared is as in nature.");
  expect(summed(told([{ ...SINUOSITY, value: 1 }]))).toBe("As in nature, but for these: how winding: straighter.");
  const { value: _, ...small } = SINUOSITY;
  expect(summed(told([small]))).toBe("Too few rivers to measure.");
  expect(told([small])[0]?.verdict).toBe("too little to tell");
});

test("a pattern is told by its name, and how far each is by the help", () => {
  const { nature: _, ...measure } = SINUOSITY;
  const pattern = { ...measure, name: "pattern", help: "", places: 1, value: 0.4 };
  const rows = told([{ ...pattern, distances: { radial: 0.4, annular: 2 } }]);
  expect(asText(rows)).toBe("Pattern: radial");
  expect(rows[0]?.help).toBe("radial 0.4, annular 2.0");
});

test("a sentence says that promises are kept, or which one is not", () => {
  const apart = { says: "Nothing crosses", counted: "segments", count: 12_345, broken: 0 };
  const joins = { says: "Every river arrives", counted: "rivers", count: 7, broken: 0 };
  expect(kept([apart, joins])).toBe(
    "Checked on this map: nothing crosses (12,345 segments), every river arrives (7 rivers).",
  );
  expect(
    kept([
      { ...apart, broken: 2 },
      { ...joins, broken: 1 },
    ]),
  ).toBe("This map breaks a promise. Nothing crosses: broken in 2 places. Every river arrives: broken in 1 place.");
});

test("a finished map is measured", () => {
  const river = new engine.River("seed=kauri");
  while (river.advance(1000));
  expect(kept(river.promises())).toMatch(
    /^Checked on this map: nothing runs uphill \([\d,]+ steps from cell to cell\), nothing crosses \([\d,]+ segments\), every river arrives \(\d+ rivers\), discharge adds up \([\d,]+ vertices\)\.$/,
  );
  const rows = told(river.measures());
  expect(rows).toHaveLength(27);
  expect(rows.filter(({ nature }) => nature !== "")).toHaveLength(14);
  expect(asText(rows)).toMatch(/^Pattern: [a-z]+$/m);
  expect(asText(rows)).toMatch(
    /^Small streams for each larger one: \d\.\d\d; .*; nature: 3\.50 to 5\.20 \(11 river basins\)$/m,
  );
});
