/** The wish to see finished rivers without their growth. */

/** Returns the reader's wish, which may change. */
export function reducedMotion(): MediaQueryList {
  return matchMedia("(prefers-reduced-motion: reduce)");
}

/** Returns whether an element shows its rivers without growth, as its author or the reader wishes. */
export function isStill(element: Element): boolean {
  return element.hasAttribute("still") || reducedMotion().matches;
}
