/** The help sheet, which lists what each key does. The same list handles the keys that act like a button. */

import { el } from "../../../browser/dom.ts";
import { isCombined, isTaken } from "../../../browser/keys.ts";
import type { CharacterSwitch } from "./character-switch.ts";

export interface HelpElements {
  dialog: HTMLDialogElement;
  open: HTMLButtonElement;
  close: HTMLButtonElement;
  list: HTMLElement;
  /** Opens the six ways to grow. */
  teach: HTMLButtonElement;
}

/** A key that acts like a button. */
export interface Shortcut {
  key: string;
  says: string;
  act: () => void;
}

/** Keys that other parts of the page handle. */
const OTHERS: readonly (readonly [keys: string, says: string])[] = [
  ["Space", "play or pause, when no control has the focus"],
  ["+ − 0", "zoom in, out, all of the map, which arrow keys move when it has the focus"],
  [
    "A T K M X",
    "look inside a map, even while it grows: attractors, tips, reach and kill, masks, captured streams; again to hide",
  ],
  ["O B D C F", "inside a finished map: orders, basins, flow, curvature, frozen courses"],
  [", .", "one step back or forward in the making of a finished map"],
  ["N", "the next great river, its way to the sea and its basin; with Shift, the previous one"],
  ["W", "the map alone, over the whole screen, as a double tap on it does; again, or Esc, to go back"],
  ["Ctrl Z", "undo; with Shift, redo; while drawing, remove the last line"],
  ["← →", "on a slider: one step; Page Up and Page Down: a large one; so does the wheel"],
  ["Enter", "in the seed box: grow at once; on the map: name the river that is shown, as a click names anything"],
  ["Esc", "close what is open, one thing at a time; while drawing: done"],
];

export class HelpSheet {
  constructor(
    private readonly elements: HelpElements,
    private readonly shortcuts: readonly Shortcut[],
    characters: CharacterSwitch,
    teach: () => void,
  ) {
    const { dialog, open, close, list } = elements;
    list.before(characters.element);
    elements.teach.addEventListener("click", () => {
      dialog.close();
      teach();
    });
    open.addEventListener("click", () => dialog.showModal());
    close.addEventListener("click", () => dialog.close());
    const rows = [...shortcuts.map(({ key, says }) => [key, says] as const), ...OTHERS, ["?", "this sheet"] as const];
    list.replaceChildren(...rows.map(([keys, says]) => rowOf(keys, says)));
    document.addEventListener("keydown", (event) => this.#onKey(event));
  }

  #onKey(event: KeyboardEvent): void {
    if (isTaken(event) || isCombined(event) || event.repeat) return;
    if (event.key === "?") this.elements.dialog.showModal();
    else this.shortcuts.find(({ key }) => key === event.key.toLowerCase())?.act();
  }
}

function rowOf(keys: string, says: string): HTMLElement {
  const caps = keys.split(" ").flatMap((key) => [el("kbd", {}, key.length === 1 ? key.toUpperCase() : key), " "]);
  return el("div", {}, el("dt", {}, ...caps), el("dd", {}, says));
}
