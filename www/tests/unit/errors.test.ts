import { expect, test } from "vitest";
import { advice } from "../../src/engine/advice.ts";
import { CODES, isRecoverable, named, PageError } from "../../src/engine/errors.ts";
import { engine } from "../core.ts";

test("no two failures have the same advice, and all of it is whole sentences", () => {
  const all = CODES.map((code) => advice(new PageError(code, "why")));
  expect(new Set(all.map(({ text }) => text)).size).toBe(CODES.length);
  for (const { title, text } of all) {
    expect(title).toMatch(/^[A-Z].*[^.]$/);
    expect(text).toMatch(/^[A-Z].*\.$/);
  }
});

test("advice to load the page again comes with the button for it", () => {
  const all = CODES.map((code) => advice(new PageError(code, "why")));
  const advised = all.filter(({ text }) => /reload|load the page again/i.test(text));
  expect(advised.length).toBeGreaterThan(3);
  expect(advised.filter(({ reload }) => !reload)).toEqual([]);
});

test("the core's refusals keep their code and message", () => {
  const refusal = thrownBy(() => engine.outlineLines("junk"));
  const error = named(refusal);
  expect([error.code, error.message]).toEqual(["bad-params", (refusal as Error).message]);
  expect(error.message).toMatch(/^character 1 is not the dot/);
  expect(isRecoverable(error)).toBe(true);
});

function thrownBy(call: () => unknown): unknown {
  try {
    call();
  } catch (error) {
    return error;
  }
  throw new Error("nothing was thrown");
}

test("a picture beyond all bounds is too large, not a panic", () => {
  const thrown = thrownBy(() => new engine.River("seed=kauri").resize(4_000_000, 4_000_000));
  expect(named(thrown).code).toBe("too-large");
});

test("a trap is a panic, and ends the picture", () => {
  const error = named(new WebAssembly.RuntimeError("unreachable"));
  expect(error.code).toBe("panic");
  expect(isRecoverable(error)).toBe(false);
});

test("memory that runs out on the way ends the picture: what there is of it is not the recipe's", () => {
  const error = named(Object.assign(new Error("rivers need 90 MB"), { code: "no-memory" }));
  expect(error.code).toBe("no-memory");
  expect(isRecoverable(error)).toBe(false);
});

test("whatever is thrown gets a name", () => {
  for (const thrown of ["text", undefined, null, 7, {}, new Error("x"), Object.assign(new Error("x"), { code: 7 })]) {
    expect(named(thrown).code).toBe("unknown");
  }
  expect(named(new RangeError("memory")).code).toBe("too-large");
  expect(named(Object.assign(new Error("x"), { code: "toString" })).code).toBe("unknown");
});
