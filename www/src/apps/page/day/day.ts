/** The country of the day: each date has a word, the same every year and for everybody. */

import words from "./words.json" with { type: "json" };

/** A year with a 29th of February, which has a word of its own. */
const LEAP_YEAR = 2024;
const DAY_MS = 86_400_000;

/** Returns the word of a day, by the date of the place where it is asked for. */
export function wordOf(day: Date): string {
  const since = Date.UTC(LEAP_YEAR, day.getMonth(), day.getDate()) - Date.UTC(LEAP_YEAR, 0);
  return words[since / DAY_MS] ?? "";
}
