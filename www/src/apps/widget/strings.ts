/** What a widget says, in English until its author says otherwise. */

import type { Count } from "../../browser/count.ts";
import type { Status } from "../../host/protocol.ts";
import { alternative, sizeOf } from "../../player/summary-text.ts";

/** A river as it stands, for a sentence about it. */
export interface Told extends Status {
  seed: string;
  /** Writes a number as the element's language does. */
  count: Count;
}

export interface Strings {
  pause: string;
  play: string;
  replay: string;
  /** The name of the picture, unless its author gave one. */
  alternative: (told: Told) => string;
  /** Announced once when the river is finished. */
  finished: (told: Told) => string;
  /** What stands in the place of a picture that failed and has no fallback. */
  failed: string;
}

export const ENGLISH: Strings = {
  pause: "Pause the rivers",
  play: "Let the rivers grow",
  replay: "Grow the rivers again",
  alternative: ({ seed, phase, summary, count }) => alternative(seed, phase, summary, count),
  finished: ({ summary, count }) => `Finished: ${sizeOf(summary, count)}.`,
  failed: "This river cannot be shown.",
};

/** Writes numbers as people do where an element's text is read. */
export function countIn(element: Element): Count {
  const language = element.closest("[lang]")?.getAttribute("lang") || undefined;
  return (value) => {
    try {
      return value.toLocaleString(language);
    } catch {
      // Not a language that anybody knows.
      return String(value);
    }
  };
}
