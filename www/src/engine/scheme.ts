/** How rivers look whose link names no style, on dark pages and light ones. */

import type { Parameter } from "./types.ts";

/** The style of rivers on dark pages. */
export const DARK_STYLE = "dark";

/** The value that every key has if nobody says otherwise, on a dark page or a light one. */
export function defaultsOf(table: readonly Parameter[], isDark: boolean): ReadonlyMap<string, string> {
  const defaults = new Map(table.map((row) => [row.key, row.default]));
  return isDark ? defaults.set("style", DARK_STYLE) : defaults;
}

/** Whether link text says itself how its rivers look. */
export function namesStyle(link: string): boolean {
  return new URLSearchParams(link).has("style");
}
