/** The name of the country on show: the map's title once the names are known, and the seed until then. */

import type { Recipe } from "../../engine/recipe.ts";
import type { NameFacts } from "../../engine/types.ts";

/** The mark of the map's title among its names. */
const TITLE = "t";

export class CountryName {
  /** A title, and what it is the title of. */
  #known = { of: "", title: "" };

  constructor(private readonly recipe: Recipe) {}

  /** The name; empty for a map without a word whose names are not known. */
  get text(): string {
    return this.#known.of === this.#subject ? this.#known.title : this.recipe.seed;
  }

  /** Takes the names of the map on show. Returns whether its name is another one now. */
  learn(names: readonly NameFacts[]): boolean {
    const before = this.text;
    const title = names.find(({ mark }) => mark === TITLE)?.name;
    if (title !== undefined && title !== "") this.#known = { of: this.#subject, title };
    return this.text !== before;
  }

  /** The values that a title depends on: titles that people give are among the names. */
  get #subject(): string {
    return JSON.stringify([this.recipe.seed, this.recipe.values.get("names") ?? ""]);
  }
}
