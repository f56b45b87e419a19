/** Lets somebody who comes without a link type a word at once. */

/** Not on screens for fingers, where a keyboard would come up over half of the map. */
const HAS_KEYBOARD = "(hover: hover) and (pointer: fine)";

/** Selects the word in its box, unless the visitor has gone elsewhere on the page meanwhile. */
export function typeAtOnce(field: HTMLInputElement): void {
  if (document.activeElement !== document.body || !window.matchMedia(HAS_KEYBOARD).matches) return;
  field.focus({ preventScroll: true });
  field.select();
}
