/** The colours of the page around an element. */

import { DARK_PAGES } from "../../browser/dark-pages.ts";

/** Returns whether the page is dark: by the `theme`, or else by its colour scheme, or else by the reader's preference. */
export function isDark(element: Element): boolean {
  const theme = element.getAttribute("theme");
  if (theme === "light" || theme === "dark") return theme === "dark";
  const schemes = getComputedStyle(element).colorScheme.split(" ");
  if (schemes.includes("dark") !== schemes.includes("light")) return schemes.includes("dark");
  return matchMedia(DARK_PAGES).matches;
}
