/** The seed box: a word, typed or thrown. */

import { setValue } from "../browser/dom.ts";

/** Long enough that a word is typed without a river for every letter, short enough to feel like an answer. */
export const TYPING_PAUSE_MS = 300;

export class SeedBox {
  #timer: ReturnType<typeof setTimeout> | undefined;
  #shown = "";

  constructor(
    private readonly form: HTMLFormElement,
    private readonly field: HTMLInputElement,
    private readonly change: (seed: string) => void,
  ) {
    field.addEventListener("input", () => this.#soon());
    field.addEventListener("blur", () => this.#leave());
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#tell();
    });
  }

  /** Shows a seed, unless it is being typed. */
  show(seed: string): void {
    this.#shown = seed;
    if (this.#timer !== undefined || this.form.ownerDocument.activeElement === this.field) return;
    setValue(this.field, seed);
  }

  /** Shows a seed that came from elsewhere, and forgets what was being typed. */
  replace(seed: string): void {
    this.#cancel();
    this.#shown = seed;
    setValue(this.field, seed);
  }

  #soon(): void {
    this.#cancel();
    this.#timer = setTimeout(() => this.#tell(), TYPING_PAUSE_MS);
  }

  /** Left behind is what grows: in the core's spelling, or the last word if the box was emptied. */
  #leave(): void {
    if (this.#timer !== undefined) this.#tell();
    setValue(this.field, this.#shown);
  }

  #cancel(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
  }

  /** An empty box is a word that has not been typed yet: the river stays. */
  #tell(): void {
    this.#cancel();
    if (this.field.value.trim() !== "") this.change(this.field.value);
  }
}
