/** What the visitor's system asks for: dark pages, and that nothing moves; and what a first visit begins with. */

import { DARK_PAGES } from "../../browser/dark-pages.ts";
import type { ShowMode } from "../../player/river-player.ts";

const prefersStill = window.matchMedia("(prefers-reduced-motion: reduce)");
export const prefersDark = window.matchMedia(DARK_PAGES);

/** How a river is shown, where the page would like to show it in this way. */
export function howFor(how: ShowMode): ShowMode {
  return prefersStill.matches ? "still" : how;
}

/** What a visit without a link begins with: the map at its best, by day and by night, in the window's shape. */
export function firstLink(): string {
  const style = prefersDark.matches ? "night" : "atlas";
  const shape = innerWidth < innerHeight ? "&aspect=0.75" : "";
  return `style=${style}&labels=some${shape}`;
}
