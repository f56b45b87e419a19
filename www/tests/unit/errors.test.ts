import { expect, test } from "vitest";
import { advice } from "../../src/engine/advice.ts";
import { type Code, isRecoverable, named, PageError } from "../../src/engine/errors.ts";
import { engine } from "../core.ts";

const CODES: Code[] = [
  "wasm-unsupported",
  "wasm-fetch",
  "wasm-mime",
  "wasm-csp",
  "wasm-timeout",
  "no-files",
  "bad-params",
  "too-large",
  "no-memory",
  "panic",
  "unknown",
];

test("every failure has a title and says what to do", () => {
  for (const code of CODES) {
    const { title, text } = advice(new PageError(code, "why"));
    expect(title).not.toBe("");
    expect(text.split(" ").length).toBeGreaterThan(8);
  }
});

test("the core's refusals keep their code and message", () => {
  let thrown: unknown;
  try {
    engine.outlineLines("junk");
  } catch (error) {
    thrown = error;
  }
  const error = named(thrown);
  expect(error.code).toBe("bad-params");
  expect(error.message).not.toBe("");
  expect(isRecoverable(error)).toBe(true);
});

test("a picture beyond all bounds is too large, not a panic", () => {
  let thrown: unknown;
  try {
    new engine.River("seed=kauri").resize(4_000_000, 4_000_000);
  } catch (error) {
    thrown = error;
  }
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
