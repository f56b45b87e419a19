/** The index of the search: made when the site is built, asked in the browser. */

import MiniSearch, { type Options, type SearchResult } from "minisearch";
import type { Section } from "./section.ts";

/** The most results that are shown. */
const MOST = 12;

/** Words that stand everywhere and say nothing of a section. */
// biome-ignore format: a list of words
const EMPTY: ReadonlySet<string> = new Set([
  "a", "an", "and", "are", "as", "at", "be", "by", "can", "do", "does", "for", "from", "how", "i", "if", "in", "is", "it", "its", "my", "of", "on",
  "or", "so", "that", "the", "their", "then", "they", "this", "to", "what", "where", "which", "with", "you", "your",
]);

/** Settings of the index, which must be read with those that it was made with. */
const OPTIONS: Options<Section> = {
  idField: "address",
  fields: ["heading", "page", "text", "code"],
  storeFields: ["address", "heading", "page", "text", "code"],
  processTerm: (term) => {
    const word = term.toLowerCase();
    return EMPTY.has(word) ? null : word;
  },
};

/** A section that was found, with the words of it that fit the question. */
export interface Found extends Section {
  readonly words: readonly string[];
}

/** Makes the index of sections, as JSON. */
export function indexOf(sections: readonly Section[]): string {
  const index = new MiniSearch<Section>(OPTIONS);
  index.addAll(sections);
  return JSON.stringify(index);
}

/** Sections that can be searched. */
export class Index {
  readonly #index: MiniSearch<Section>;

  /** Reads an index that `indexOf` made. */
  constructor(json: string) {
    this.#index = MiniSearch.loadJSON<Section>(json, OPTIONS);
  }

  /** Finds the sections that have all words of a question, or if there are none, those that have some. */
  find(question: string): Found[] {
    const all = this.#search(question, "AND");
    const results = all.length > 0 ? all : this.#search(question, "OR");
    return results.slice(0, MOST).map(foundOf);
  }

  #search(question: string, combineWith: "AND" | "OR"): SearchResult[] {
    return this.#index.search(question, {
      combineWith,
      boost: { heading: 4, page: 2, code: 0.3 },
      // A word may be one that is still being typed, or have a fault. Both count far less than the word itself.
      prefix: true,
      fuzzy: (word) => (word.length > 4 ? 0.2 : false),
      weights: { prefix: 0.25, fuzzy: 0.05 },
    });
  }
}

function foundOf({ address, heading, page, text, code, terms }: SearchResult): Found {
  return { address, heading, page, text, code, words: terms };
}
