/** Undo and redo by the browser's Back and Forward: each step of the visitor is an entry of the history. */

import { addressOf } from "../../browser/address.ts";
import { isTaken } from "../../browser/keys.ts";

/** Changes of the same values belong to one step until the hand has rested this long. */
const REST_MS = 1000;
/** Values that are looked through: their changes belong to one step, however long each is looked at. */
const LOOKED_THROUGH: readonly string[] = ["style"];

/** The state of an entry of the browser's history. */
interface Entry {
  /** The number of steps that led to it. */
  step: number;
}

export interface UndoElements {
  /** The place of both buttons, which is hidden until there is something to undo or redo. */
  group: HTMLElement;
  undo: HTMLButtonElement;
  redo: HTMLButtonElement;
}

export class Undo {
  #step = stepOf(history.state) ?? 0;
  #last = this.#step;
  #changed: { what: string; at: number } | undefined;

  constructor(
    private readonly elements: UndoElements,
    /** Called before a step is undone or redone, to write what is still waiting. */
    private readonly leaving: () => void,
    /** Returns whether something that is open has its own undo. */
    private readonly isElsewhere: () => boolean,
  ) {
    elements.undo.addEventListener("click", () => this.undo());
    elements.redo.addEventListener("click", () => this.redo());
    document.addEventListener("keydown", (event) => this.#onKey(event));
    this.#show();
  }

  undo(): void {
    this.leaving();
    if (this.#step > 0) history.back();
  }

  redo(): void {
    this.leaving();
    if (this.#step < this.#last) history.forward();
  }

  /** Returns whether a change is a new step. `what` names a gradual change, which may continue the last step. */
  isStep(what?: string): boolean {
    const before = this.#changed;
    const at = performance.now();
    this.#changed = what === undefined ? undefined : { what, at };
    if (before === undefined || before.what !== what) return true;
    return at - before.at > REST_MS && !LOOKED_THROUGH.includes(before.what);
  }

  /** Writes the link on show into the address: a step as a new entry, anything else in place of the current one. */
  write(link: string, isStep: boolean): void {
    const step = isStep ? this.#step + 1 : this.#step;
    try {
      const entry: [Entry, string, string] = [{ step }, "", addressOf(link, location.href)];
      if (isStep) history.pushState(...entry);
      else history.replaceState(...entry);
      if (isStep) this.#last = step;
      this.#step = step;
    } catch {
      // A sandboxed frame may not change its address. The picture is not affected, and the link can still be copied.
    }
    this.#show();
  }

  /**
   * Follows the browser to another entry. One that the page has not written, such as a link pasted into the address,
   * becomes the last.
   */
  arrived(): void {
    this.#changed = undefined;
    const step = stepOf(history.state);
    if (step === undefined) this.#last = this.#step + 1;
    this.#step = step ?? this.#last;
    this.#last = Math.max(this.#last, this.#step);
    this.#show();
  }

  #onKey(event: KeyboardEvent): void {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || isTaken(event) || this.isElsewhere()) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) this.undo();
    else if (key === "y" || key === "z") this.redo();
    else return;
    event.preventDefault();
  }

  #show(): void {
    this.elements.undo.disabled = this.#step === 0;
    this.elements.redo.disabled = this.#step === this.#last;
    // Both at once: if each came and went by itself, the other would move under the finger.
    this.elements.group.hidden = this.#last === 0;
  }
}

function stepOf(state: unknown): number | undefined {
  const step = (state as Partial<Entry> | null)?.step;
  return typeof step === "number" ? step : undefined;
}
