/** The wish to see finished rivers without their growth. */

export const REDUCED_MOTION = "(prefers-reduced-motion: reduce)";

/** Returns whether an element shows its rivers without growth, as its author or the reader wishes. */
export function isStill(element: Element): boolean {
  return element.hasAttribute("still") || matchMedia(REDUCED_MOTION).matches;
}
