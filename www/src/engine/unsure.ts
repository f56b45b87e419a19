/** What is not asked any more after a failure. Apart from the names of failures: an element on a page need not know it. */

import type { PageError } from "./errors.ts";

/** Whether nobody knows in what state the engine is: nothing is asked of what it was at, not even to go. */
export function isEngineUnsure({ code }: PageError): boolean {
  return code === "panic" || code === "unknown";
}
