/** Keys of the whole page: finds out whether a key means something else where it goes, and handles Escape. */

import { Typing } from "./typing.ts";

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
  if (!doCharactersAct && isCharacter(event) && key !== " ") return true;
  return isIn(LISTS) || (key === " " && isIn(PRESSED)) || (SLIDER_KEYS.test(key) && isIn(SLIDERS));
}

/** Returns whether a key is combined with a modifier. Shift does not count, since some characters need it. */
export function isCombined({ altKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
  return altKey || ctrlKey || metaKey;
}

/** True while single characters act on the page; false where they were switched off, as WCAG 2.1.4 asks. */
let doCharactersAct = true;

/** Switches single characters on or off; combinations, Escape, arrows and the space bar go on. */
export function letCharactersAct(doThey: boolean): void {
  doCharactersAct = doThey;
}

/** Holds characters back until it is sure that they are no part of a sentence. To be called once, before all others. */
export function guardCharacters(): void {
  const replayed = new WeakSet<Event>();
  const typing = new Typing<KeyboardEvent>(({ key, code, shiftKey, target }) => {
    const again = new KeyboardEvent("keydown", { key, code, shiftKey, bubbles: true, cancelable: true });
    replayed.add(again);
    const place = target instanceof Element && target.isConnected ? target : document.body;
    place.dispatchEvent(again);
  });
  const judge = (event: KeyboardEvent): void => {
    if (!isCharacter(event) || replayed.has(event)) return;
    // A space between two words presses no button, though one may have the focus from an earlier click.
    if (typing.isGoingOn && event.key === " " && !isUnderDialog() && isPressed(event)) event.preventDefault();
    else if (isTaken(event)) return;
    // The characters of a held key are not typed.
    if (!event.repeat && typing.judge(event.key, event) !== "acts") event.stopImmediatePropagation();
  };
  window.addEventListener("keydown", judge, { capture: true });
}

function isPressed({ target }: KeyboardEvent): boolean {
  return target instanceof Element && target.matches("button, a, summary");
}

function isCharacter(event: KeyboardEvent): boolean {
  return [...event.key].length === 1 && !isCombined(event);
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
