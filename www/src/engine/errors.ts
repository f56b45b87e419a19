/**
 * Names failures: every one that reaches the page passes through `named`, so that nobody is shown a stack trace or a
 * blank canvas.
 */

import { CODES, type Code } from "./codes.ts";
import { PageError } from "./page-error.ts";

export { CODES, type Code } from "./codes.ts";
export { isRecoverable, PageError } from "./page-error.ts";

function isCode(code: unknown): code is Code {
  return CODES.some((known) => known === code);
}

/** Turns whatever was thrown into an error with a code. The core's errors carry one; a trap in wasm is a panic. */
export function named(thrown: unknown): PageError {
  if (thrown instanceof PageError) return thrown;
  if (!(thrown instanceof Error)) return new PageError("unknown", String(thrown));
  if ("code" in thrown && isCode(thrown.code)) return new PageError(thrown.code, thrown.message);
  if (thrown.name === "RuntimeError") return new PageError("panic", thrown.message);
  // Typed arrays and WebAssembly.Memory throw a `RangeError` when memory cannot grow.
  if (thrown instanceof RangeError) return new PageError("too-large", thrown.message);
  return new PageError("unknown", thrown.message);
}
