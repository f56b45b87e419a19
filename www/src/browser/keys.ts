/** Keys of the whole page: which of them mean something else where they go, and what Escape takes back. */

/** Where keys write. */
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
/** Where a letter picks one of several. */
const LISTS = "select, [role=menu], [role=listbox]";
/** What the space bar presses. */
const PRESSED = "button, a, input, select, summary";
/** What has arrow keys of its own. */
const SLIDERS = "input[type=range], [role=slider]";
const SLIDER_KEYS = /^(Arrow|Page|Home$|End$)/;

/** Whether a key is not the page's: a dialog lies over that, somebody types, or the key means something where the focus is. */
export function isTaken(event: KeyboardEvent): boolean {
  const { key, target } = event;
  if (event.defaultPrevented || event.isComposing || isUnderDialog()) return true;
  const isIn = (places: string): boolean => target instanceof Element && target.closest(places) !== null;
  if (isIn(TEXT)) return true;
  // A list knows no such combinations.
  if (event.ctrlKey || event.metaKey) return false;
  return isIn(LISTS) || (key === " " && isIn(PRESSED)) || (SLIDER_KEYS.test(key) && isIn(SLIDERS));
}

/** Whether a key comes with one that makes it mean something else. Shift belongs to some signs. */
export function isCombined({ altKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
  return altKey || ctrlKey || metaKey;
}

/** Something that Escape takes back. */
export interface Escapable {
  /** Takes it back; returns whether there was anything. */
  escape(): boolean;
}

/** Each press of Escape takes back one thing, the first of these that there is. A dialog is closed by the browser. */
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
