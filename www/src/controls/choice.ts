/** A list of words to choose from. Where the seed's word may decide, that is the first, and says what is decided. */

import { el, setText, setValue } from "../browser/dom.ts";
import { AUTO } from "../engine/link-text.ts";
import type { Parameter } from "../engine/table.ts";

const AS_THE_WORD_DECIDES = "as the word decides";

export class Choice {
  readonly #options: ReadonlyMap<string, HTMLOptionElement>;

  constructor(
    private readonly select: HTMLSelectElement,
    private readonly parameter: Parameter | undefined,
    choose: (value: string) => void,
  ) {
    const { choices = [], decided = false } = parameter ?? {};
    const all = decided ? [{ value: AUTO, label: AS_THE_WORD_DECIDES }, ...choices] : choices;
    this.#options = new Map(all.map(({ value, label }) => [value, el("option", { value }, label)]));
    select.replaceChildren(...this.#options.values());
    select.addEventListener("change", () => choose(select.value));
  }

  /** Returns the entry of a value. */
  option(value: string): HTMLOptionElement | undefined {
    return this.#options.get(value);
  }

  /** Shows a value. `automatic` is the one that the word has decided, if it is left to that. */
  show(text: string, automatic: string | undefined): void {
    const label = automatic === undefined ? undefined : this.#labelOf(automatic);
    const unnamed = this.#labelOf(AUTO) ?? AS_THE_WORD_DECIDES;
    setText(this.#options.get(AUTO), label === undefined ? unnamed : `${AUTO}: ${label}`);
    setValue(this.select, text);
  }

  #labelOf(choice: string): string | undefined {
    return this.parameter?.choices?.find(({ value }) => value === choice)?.label;
  }
}
