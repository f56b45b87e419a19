/** Keys of the whole page: finds out whether a key means something else where it goes, and handles Escape. */

/** Places where keys write. */
const TEXT = `textarea, [contenteditable=""], [contenteditable=true], input:not(${[
  "range",
  "checkbox",
  "radio",
  "button",
  "file",
  "color",
]
  .map((type) => `[type=${type}]`)
  .join()})`;
/** Places where a letter picks an option. */
const LISTS = "select, [role=menu], [role=listbox]";
/** Elements that the space bar presses. */
const PRESSED = "button, a, input, select, summary";
/** Elements that use the arrow keys. */
const SLIDERS = "input[type=range], [role=slider]";
const SLIDER_KEYS = /^(Arrow|Page|Home$|End$)/;

/**
 * Returns whether a key is not for the page: a dialog is open, somebody is typing, or the key means something where the
 * focus is.
 */
export function isTaken(event: KeyboardEvent): boolean {
  const { key, target } = event;
  if (event.defaultPrevented || event.isComposing || isUnderDialog()) return true;
  const isIn = (places: string): boolean => target instanceof Element && target.closest(places) !== null;
  if (isIn(TEXT)) return true;
  // Lists, buttons and sliders do not use these combinations.
  if (event.ctrlKey || event.metaKey) return false;
  return isIn(LISTS) || (key === " " && isIn(PRESSED)) || (SLIDER_KEYS.test(key) && isIn(SLIDERS));
}

/** Returns whether a key is combined with a modifier. Shift does not count, since some characters need it. */
export function isCombined({ altKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
  return altKey || ctrlKey || metaKey;
}

/** Something that Escape can undo or close. */
export interface Escapable {
  /** Undoes or closes it. Returns whether there was anything. */
  escape(): boolean;
}

/** Handles Escape: each press undoes or closes the first of these that it can. A dialog is closed by the browser. */
export function answerEscape(innermostFirst: readonly Escapable[]): void {
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.repeat || isCombined(event)) return;
    if (event.defaultPrevented || event.isComposing || isUnderDialog()) return;
    if (innermostFirst.some((one) => one.escape())) event.preventDefault();
  });
}

function isUnderDialog(): boolean {
  return document.querySelector("dialog[open]") !== null;
}
