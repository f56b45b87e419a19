/** Dark pages: what they are, and how rivers look there whose link names no style. */

/** The media query of a reader who prefers dark pages. */
export const DARK_PAGES = "(prefers-color-scheme: dark)";

/** The style for them. */
export const DARK_STYLE = "dark";

/** Whether link text says itself how its rivers look. */
export function namesStyle(link: string): boolean {
  return new URLSearchParams(link).has("style");
}
