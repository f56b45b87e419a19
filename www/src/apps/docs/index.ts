/** The index of the search: made when the site is built, asked in the browser. */

import MiniSearch, { type Options, type SearchResult } from "minisearch";
import type { Section } from "./section.ts";

/** The most results that are shown. */
const MOST = 12;

/** How the index is made. It must be read with the same settings. */
const OPTIONS: Options<Section> = {
  idField: "address",
  fields: ["heading", "page", "text", "code"],
  storeFields: ["address", "heading", "page", "text", "code"],
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
      // The word that is being typed may be anywhere.
      prefix: true,
      fuzzy: (word) => (word.length > 4 ? 0.2 : false),
    });
  }
}

function foundOf({ address, heading, page, text, code, terms }: SearchResult): Found {
  return { address, heading, page, text, code, words: terms };
}
