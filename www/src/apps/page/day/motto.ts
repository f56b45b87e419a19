/** The line below the page's name, which says of the country of the day that it is. */

import { setText } from "../../../browser/dom.ts";

const OF_THE_DAY = "Country of the day. Type a word, get another.";

export class Motto {
  readonly #usual: string;

  constructor(
    private readonly line: HTMLElement,
    /** The word of the day, if the visitor has come for its country. */
    private readonly word: string | undefined,
  ) {
    this.#usual = line.textContent ?? "";
  }

  /** Follows the word on show. */
  show(word: string): void {
    const isOfTheDay = word === this.word;
    setText(this.line, isOfTheDay ? OF_THE_DAY : this.#usual);
    this.line.toggleAttribute("data-says", isOfTheDay);
  }
}
