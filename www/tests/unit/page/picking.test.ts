import { expect, test } from "vitest";
import { awayFrom, nearest } from "../../../src/apps/page-worker/picking.ts";

const at = { x: 0.5, y: 0.5 };

test("a line is as far away as its nearest point, in widths of the map", () => {
  const line = [0.2, 0.6, 0.8, 0.6];
  expect(awayFrom({ line }, at, 1)).toBeCloseTo(0.1);
  // The map is half as high as it is wide.
  expect(awayFrom({ line }, at, 0.5)).toBeCloseTo(0.05);
  expect(awayFrom({ line, isSpaced: true }, at, 1)).toBeCloseTo(Math.hypot(0.3, 0.1));
  expect(awayFrom({ line: [0.5, 0.1] }, at, 1)).toBeCloseTo(0.4);
  expect(awayFrom({ line: [] }, at, 1)).toBe(Number.POSITIVE_INFINITY);
});

test("the nearest within reach comes first, and of letters that are hit nothing is nearer", () => {
  const far = { line: [0.5, 0.9], half: 0 };
  const near = { line: [0.5, 0.52], half: 0 };
  const letter = { line: [0.5, 0.53], half: 0.04 };
  expect(nearest([far, near, letter], at, 0.03, 1)).toEqual([letter, near]);
  expect(nearest([far, near, letter], at, 0.5, 1)).toEqual([letter, near, far]);
  expect(nearest([far], at, 0.1, 1)).toEqual([]);
});
