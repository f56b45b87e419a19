/**
 * Failures that leave the engine in an unknown state. Separate from the error codes: an element on a page does not need
 * this.
 */

import type { PageError } from "./errors.ts";

/**
 * Returns whether the engine's state is unknown: then nothing may be called on the object that failed, not even `free`.
 */
export function isEngineUnsure({ code }: PageError): boolean {
  return code === "panic" || code === "unknown";
}
