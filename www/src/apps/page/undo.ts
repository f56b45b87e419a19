/** Undo and redo, which are the browser's own Back and Forward: each step of a person is an entry of its history. */

import { addressOf } from "../../browser/address.ts";
import { isTaken } from "../../browser/keys.ts";

/** Changes of the same thing belong to one step, until the hand has rested so long. */
const REST_MS = 1000;

/** What an entry of the browser's history says of itself. */
interface Entry {
  /** How many steps led to it. */
  step: number;
}

export interface UndoElements {
  undo: HTMLButtonElement;
  redo: HTMLButtonElement;
}

export class Undo {
  #step = stepOf(history.state) ?? 0;
  #last = this.#step;
  #changed: { what: string; at: number } | undefined;

  constructor(
    private readonly elements: UndoElements,
    /** Something is about to be taken back: what is still to be written down has to be now. */
    private readonly leaving: () => void,
    /** Whether something open has an undo of its own. */
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

  /** Something changes, little by little if it has a name: whether that is a step of its own. */
  isStep(what?: string): boolean {
    const before = this.#changed;
    const at = performance.now();
    this.#changed = what === undefined ? undefined : { what, at };
    return before === undefined || before.what !== what || at - before.at > REST_MS;
  }

  /** Writes the link of what is shown into the address: of a step as another entry, otherwise in place of the last. */
  write(link: string, isStep: boolean): void {
    const step = isStep ? this.#step + 1 : this.#step;
    try {
      const entry: [Entry, string, string] = [{ step }, "", addressOf(link, location.href)];
      if (isStep) history.pushState(...entry);
      else history.replaceState(...entry);
      if (isStep) this.#last = step;
      this.#step = step;
    } catch {
      // A sandboxed frame may not touch its address; the picture is no worse for it, and "Copy link" still works.
    }
    this.#show();
  }

  /** The browser went to another entry. One that nobody has written yet, as a link makes that is pasted over the address, is the last. */
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
  }
}

function stepOf(state: unknown): number | undefined {
  const step = (state as Partial<Entry> | null)?.step;
  return typeof step === "number" ? step : undefined;
}
