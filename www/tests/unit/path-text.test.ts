import { expect, test } from "vitest";
import { dotsOf, lineOf, linesOf, ringsOf } from "../../src/browser/path-text.ts";

test("points are dots, in hundredths of a unit", () => {
  expect(dotsOf(Float32Array.of(1, 2, 3.456, 4))).toBe("M1 2h0M3.46 4h0");
  expect(dotsOf(new Float32Array())).toBe("");
});

test("lines go through their points, and one of a single point is a dot", () => {
  expect(linesOf([Float32Array.of(0, 0, 1, 2, 3, 4), Float32Array.of(5, 6)])).toBe("M0 0L1 2L3 4M5 6h0");
});

test("a line may have more decimal places", () => {
  expect(lineOf(Float32Array.of(0.12345, 0.5, 1, 0), 4)).toBe("M0.1235 0.5L1 0");
  expect(lineOf(new Float32Array())).toBe("");
});

test("a coast is closed, and what has no line is not", () => {
  expect(lineOf(Float32Array.of(0, 0, 0.5, 0.25, 1, 1), 4, true)).toBe("M0 0L0.5 0.25L1 1z");
  expect(lineOf(Float32Array.of(0.5, 0.25), 4, true)).toBe("M0.5 0.25h0");
  expect(lineOf(new Float32Array(), 4, true)).toBe("");
});

test("a ring is smooth, ends where it began, and touches the middles of its sides", () => {
  const square = Float32Array.of(0, 0, 4, 0, 4, 4, 0, 4);
  expect(ringsOf([square, Float32Array.of(0, 0, 1, 1)])).toBe("M0 2Q0 0 2 0Q4 0 4 2Q4 4 2 4Q0 4 0 2z");
});
