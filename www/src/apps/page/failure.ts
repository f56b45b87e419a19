/** Failures that the visitor, or the owner of the site, has to know of. */

import { named, type PageError } from "../../engine/errors.ts";
import { elements } from "./elements.ts";
import { showFailure } from "./status.ts";

/** Shows a failure that leaves no picture, in the picture's place and on the console. */
export function fail(thrown: unknown): void {
  const error = warn(thrown);
  elements.facade.hidden = true;
  showFailure(elements.failure, error);
}

/** Logs a failure on the console, for the owner of the site. */
export function warn(thrown: unknown): PageError {
  const error = named(thrown);
  console.warn(`riverseed: ${error.code}: ${error.message}`);
  return error;
}
