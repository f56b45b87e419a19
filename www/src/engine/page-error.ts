/** A failure with a code. What needs to name no others, as the script of an element, loads nothing else about them. */

import type { Code } from "./codes.ts";

export class PageError extends Error {
  constructor(
    readonly code: Code,
    message: string,
  ) {
    super(message);
    this.name = "PageError";
  }
}

const RECOVERABLE: ReadonlySet<Code> = new Set(["bad-params", "too-large", "no-land", "bad-image"]);

/** Returns whether the picture on the page is still good after a failure, so that a note beside it is enough. */
export function isRecoverable(error: PageError): boolean {
  return RECOVERABLE.has(error.code);
}
