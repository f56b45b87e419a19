import { expect, test } from "vitest";
import { keysOf, MACROS, placeOf, valuesAt } from "../../src/controls/macros.ts";
import { engine } from "../core.ts";
import { table } from "../table.ts";

const rows = new Map(table.parameters.map((parameter) => [parameter.key, parameter]));
const GROWTHS = ["drainage", "colonize", "brownian"];

function valuesOf(link: string): Map<string, string> {
  return new Map(engine.readLink(link).values);
}

for (const macro of MACROS)
  for (const growth of GROWTHS) {
    test(`${macro.name}: every place is a link without a mistake, and is found again: ${growth}`, () => {
      for (let place = 0; place <= 1; place += 0.05) {
        const set = valuesAt(macro, place, rows, valuesOf(`growth=${growth}`));
        const link = set.map(([key, text]) => `${key}=${text}`).join("&");
        const read = engine.readLink(`growth=${growth}&${link}`);
        expect(read.notices).toEqual([]);
        const values = new Map(read.values);
        for (const [key, text] of set) expect(values.get(key)).toBe(text);
        // Whole numbers are as coarse as they are.
        expect(Math.abs(placeOf(macro, values) - place)).toBeLessThan(0.13);
      }
    });

    test(`${macro.name}: the middle is the usual: ${growth}`, () => {
      const values = valuesOf(`country=usual&growth=${growth}`);
      for (const [key, text] of valuesAt(macro, 0.5, rows, values)) expect([key, text]).toEqual([key, values.get(key)]);
      expect(placeOf(macro, values)).toBeCloseTo(0.5);
    });
  }

test("what lies beyond a macro's ends stands at them", () => {
  const winding = MACROS.find(({ name }) => name === "winding");
  const rivers = MACROS.find(({ name }) => name === "rivers");
  if (!winding || !rivers) throw new Error("no such macro");
  expect(placeOf(winding, valuesOf("meander-rounds=400"))).toBe(1);
  expect(placeOf(winding, valuesOf("meander-rounds=0"))).toBe(0);
  expect(placeOf(rivers, valuesOf("growth=colonize&trim=400"))).toBe(0);
  expect(placeOf(rivers, valuesOf("growth=brownian&sensitivity=64"))).toBe(0);
});

test("rivers that do not meander are straight, and begin to when they are to wind", () => {
  const winding = MACROS.find(({ name }) => name === "winding");
  if (!winding) throw new Error("no such macro");
  const values = valuesOf("meander=none");
  expect(placeOf(winding, values)).toBe(0);
  expect(valuesAt(winding, 0.75, rows, values)).toEqual([
    ["meander", "bend"],
    ["meander-rounds", "60"],
    ["meander-elsewhere", "0.5"],
  ]);
});

test("a macro names parameters that there are", () => {
  for (const macro of MACROS) for (const key of keysOf(macro)) expect(rows.has(key), key).toBe(true);
});
