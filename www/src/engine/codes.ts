/** The codes of failures; `advice.ts` says what a person can do about each. */

export const CODES = [
  "wasm-unsupported",
  "wasm-fetch",
  "wasm-mime",
  "wasm-csp",
  "wasm-timeout",
  "file-missing",
  "bad-params",
  "too-large",
  "no-memory",
  "no-land",
  "bad-image",
  "panic",
  "unknown",
] as const;

export type Code = (typeof CODES)[number];
