import { expect, test } from "vitest";
import { count } from "../../src/browser/count.ts";
import {
  LOG_STEPS,
  logStep,
  numberText,
  position,
  type Range,
  rangeOf,
  share,
  sidesOf,
  sidesText,
  spoken,
  textAt,
} from "../../src/controls/values.ts";
import type { Parameter } from "../../src/engine/table.ts";
import { engine } from "../core.ts";
import { table } from "../table.ts";

const linear: Range = { min: 0, max: 2, step: 0.01, isLog: false };
const many: Range = { min: 100, max: 1_000_000, step: 1, isLog: true };
const few: Range = { min: 1, max: 64, step: 1, isLog: true };

const ranges = table.parameters.flatMap((parameter) => {
  const range = rangeOf(parameter);
  return range && range.min < range.max ? [{ parameter, range }] : [];
});

test("a linear slider stands at its value", () => {
  expect(position(0.6, linear)).toBe(0.6);
  expect(textAt(0.6, linear)).toBe("0.6");
});

test("numbers carry no noise of binary fractions", () => {
  expect(numberText(0.1 + 0.2, 0.1)).toBe("0.3");
  expect(numberText(0.30000000000000004, 0.05)).toBe("0.3");
  expect(numberText(12, 0.5)).toBe("12");
});

test("a logarithmic slider gives round values", () => {
  expect(textAt(position(12_000, many), many)).toBe("12000");
  for (let place = 0; place <= LOG_STEPS; place++) expect(Number(textAt(place, many)) % 1).toBe(0);
});

test("both ends of every slider of the table are its range", () => {
  for (const { parameter, range } of ranges) {
    const [low, high] = range.isLog ? [0, LOG_STEPS] : [range.min, range.max];
    expect([parameter.key, Number(textAt(low, range)), Number(textAt(high, range))]).toEqual([
      parameter.key,
      range.min,
      range.max,
    ]);
  }
});

test("a slider never leaves its range, and grows with its place", () => {
  for (const { range } of ranges.filter((one) => one.range.isLog)) {
    let last = Number.NEGATIVE_INFINITY;
    for (let place = 0; place <= LOG_STEPS; place++) {
      const value = Number(textAt(place, range));
      expect(value).toBeGreaterThanOrEqual(Math.max(last, range.min));
      expect(value).toBeLessThanOrEqual(range.max);
      last = value;
    }
  }
});

test("a key press always reaches another value, until the end", () => {
  for (const { range } of ranges.filter((one) => one.range.isLog)) {
    let value = range.min;
    for (let presses = 0; value < range.max; presses++) {
      const next = Number(logStep(value, 1, 0.02, range));
      expect(next).toBeGreaterThan(value);
      expect(presses).toBeLessThan(2000);
      value = next;
    }
    expect(Number(logStep(value, 1, 0.02, range))).toBe(range.max);
    expect(Number(logStep(range.max, -1, 0.02, range))).toBeLessThan(range.max);
    expect(Number(logStep(range.min, -1, 0.02, range))).toBe(range.min);
  }
});

test("what a slider says, the core reads without a notice and spells the same", () => {
  for (const { parameter, range } of ranges) {
    for (let i = 0; i <= 50; i++) {
      const place = range.isLog ? (LOG_STEPS * i) / 50 : range.min + ((range.max - range.min) * i) / 50;
      const text = textAt(place, range);
      // Of the sea 0 stands for what suits the land.
      if (parameter.key === "sea" && text === "0") continue;
      const reading = engine.readLink(`${parameter.key}=${text}`);
      expect(reading.notices).toEqual([]);
      expect(new Map(reading.values).get(parameter.key)).toBe(text);
    }
  }
});

test("the share of a slider runs from 0 to 1", () => {
  expect(share(0, linear)).toBe(0);
  expect(share(2, linear)).toBe(1);
  expect(share(8, few)).toBeCloseTo(0.5);
});

test("sides are read and written in the table's order", () => {
  const sides = table.parameters.find(({ kind }) => kind === "sides");
  expect(sides).toBeDefined();
  expect(sidesOf("sw")).toEqual(["s", "w"]);
  expect(sidesText(new Set(["w", "n"]), sides as Parameter)).toBe("nw");
});

test("numbers are written for people and spoken with their unit", () => {
  expect(count(12_000)).toBe("12,000");
  expect(spoken("12000", "nodes")).toBe("12,000 nodes");
  expect(spoken("0.6", "")).toBe("0.6");
});
