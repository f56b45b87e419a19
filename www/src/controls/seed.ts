/** The box in which the seed is typed. */

import { setValue } from "../browser/dom.ts";

/**
 * The pause after typing before a river grows: long enough to type a word without a river for every letter, short
 * enough to feel responsive.
 */
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
      if (this.#isBlank) this.replace(this.#shown);
      else this.#tell();
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

  get #isBlank(): boolean {
    return this.field.value.trim() === "";
  }

  #soon(): void {
    this.#cancel();
    this.#timer = setTimeout(() => this.#tell(), TYPING_PAUSE_MS);
  }

  /** Shows the seed that is growing, in the core's spelling, when the box loses the focus. */
  #leave(): void {
    if (this.#timer !== undefined) this.#tell();
    setValue(this.field, this.#shown);
  }

  #cancel(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
  }

  /** Reports the typed seed. An empty box keeps the river; Enter brings its word back. */
  #tell(): void {
    this.#cancel();
    if (!this.#isBlank) this.change(this.field.value);
  }
}
