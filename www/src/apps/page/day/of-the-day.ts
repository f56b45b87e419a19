/** What the page says while it shows the country of the day. */

const WORDS = "Country of the day";

export class OfTheDay {
  constructor(
    /** The line for windows that have no room for a caption. */
    private readonly line: HTMLElement,
    /** The word of the day, if the visitor has come for its country. */
    private readonly word: string | undefined,
  ) {}

  /** Returns what a caption says of a word; empty unless it is that of the day. */
  words(word: string): string {
    return word === this.word ? WORDS : "";
  }

  /** Follows the word on show. */
  show(word: string): void {
    this.line.textContent = this.words(word);
  }
}
