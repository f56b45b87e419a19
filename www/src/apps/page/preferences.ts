/** The preferences of the visitor's system, dark pages and reduced motion, and the link of a first visit. */

import { DARK_PAGES } from "../../browser/dark-pages.ts";
import type { ShowMode } from "../../player/river-player.ts";

const prefersStill = window.matchMedia("(prefers-reduced-motion: reduce)");
export const prefersDark = window.matchMedia(DARK_PAGES);

/** Returns `how`, or "still" if the visitor prefers reduced motion. */
export function howFor(how: ShowMode): ShowMode {
  return prefersStill.matches ? "still" : how;
}

/**
 * Returns the link of a visit without one: a map with labels, in the style for light or dark pages and the window's
 * shape.
 */
export function firstLink(): string {
  const style = prefersDark.matches ? "night" : "atlas";
  const shape = innerWidth < innerHeight ? "&aspect=0.75" : "";
  return `style=${style}&labels=some${shape}`;
}
