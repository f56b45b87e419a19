/** The texts of a widget, in English unless its author replaces them. */

import type { Count } from "../../browser/count.ts";
import type { Status } from "../../host/protocol.ts";
import { alternative, sizeOf } from "../../player/summary-text.ts";

/** A river's present status, for a sentence about it. */
export interface Told extends Status {
  seed: string;
  /** Writes a number as the element's language does. */
  count: Count;
}

export interface Strings {
  pause: string;
  play: string;
  replay: string;
  /** The text alternative of the picture, unless its author gave one. */
  alternative: (told: Told) => string;
  /** Announced once when the river is finished. */
  finished: (told: Told) => string;
  /** The text of the link to the page that made the map. */
  maker: string;
  /** The text in place of a picture that failed and has no fallback. */
  failed: string;
}

export const ENGLISH: Strings = {
  pause: "Pause the rivers",
  play: "Let the rivers grow",
  replay: "Grow the rivers again",
  alternative: ({ seed, phase, summary, count }) => alternative(seed, phase, summary, count),
  finished: ({ summary, count }) => `Finished: ${sizeOf(summary, count)}.`,
  maker: "Made with Riverseed",
  failed: "This river cannot be shown.",
};

/**
 * A language and a number that it writes with the same digits as scripts do, and without a separator. For these the
 * browser is not asked: its first answer takes it up to a tenth of a second, in which the page stands still.
 */
const PLAIN = /^(de|en|es|fr|it|ja|nl|pt|ru|zh)(-\w+)? \d{1,3}$/i;

/** Returns a way to write numbers in the language of an element. */
export function countIn(element: Element): Count {
  const language = element.closest("[lang]")?.getAttribute("lang") || undefined;
  return (value) => {
    try {
      return PLAIN.test(`${language} ${value}`) ? String(value) : value.toLocaleString(language);
    } catch {
      // An unknown language.
      return String(value);
    }
  };
}
