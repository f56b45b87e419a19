/** The preferences of the visitor's system, dark pages and reduced motion, and the link of a first visit. */

import { DARK_PAGES } from "../../browser/dark-pages.ts";
import { linkText } from "../../engine/link-text.ts";
import type { ShowMode } from "../../player/river-player.ts";
import { wordOf } from "./day/day.ts";

const prefersStill = window.matchMedia("(prefers-reduced-motion: reduce)");
export const prefersDark = window.matchMedia(DARK_PAGES);

/** Returns how maps are shown that are to be seen growing: not so if the visitor prefers reduced motion. */
export function howToGrow(): ShowMode {
  return prefersStill.matches ? "still" : "watch";
}

/** The width over the height of a first map in a window that is higher than wide. In others it is the default. */
const UPRIGHT = "0.75";

/** Returns the link of a visit without one: the country of the day, in the window's shape. */
export function firstLink(): string {
  return linkText([["seed", wordOf(new Date())], ...(isUpright() ? ([["aspect", UPRIGHT]] as const) : [])]);
}

/** Returns the shape of a fresh map in this window: the shape that the map has, if somebody chose that. */
export function freshAspect(now: string, usual: string): string {
  return now !== usual && now !== UPRIGHT ? now : shapeOfWindow(usual);
}

/** Returns the shape of a map for which nobody chose one, in this window. */
export function shapeOfWindow(usual: string): string {
  return isUpright() ? UPRIGHT : usual;
}

function isUpright(): boolean {
  return innerWidth < innerHeight;
}
