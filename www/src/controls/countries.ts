/** The kinds of country: a button for each, and a first one that leaves the choice to the word. */

import { el } from "../browser/dom.ts";
import { AUTO } from "../engine/link-text.ts";
import type { Country, Parameter } from "../engine/table.ts";
import { Buttons } from "./buttons.ts";

type Values = ReadonlyMap<string, string>;

/** The key that names a country. */
export const COUNTRY = "country";

/** The number of buttons, in the table's order, that are in sight from the beginning. */
const FIRST = 5;

/** The folder of the pictures that build/button-pictures.ts draws, beside the page. */
const PICTURES = "./countries";

const BY_THE_WORD: Country = {
  name: AUTO,
  label: "As the word decides",
  help: "Every word draws a country of its own.",
};

export class Countries {
  readonly element: HTMLElement;
  readonly #all: readonly Country[];
  readonly #buttons: Buttons<Country>;

  /** Makes the buttons, with a padlock above them. */
  constructor(table: readonly Country[], padlock: HTMLElement, choose: (country: Country) => void) {
    this.#all = [BY_THE_WORD, ...table];
    const pictureOf = ({ name }: Country) => (name === AUTO ? undefined : `${PICTURES}/${name}.webp`);
    this.#buttons = new Buttons("Countries", this.#all, choose, pictureOf, FIRST);
    const head = el("div", { class: "control-head" }, el("span", {}, "Country"), padlock);
    this.element = el("div", {}, head, this.#buttons.element);
  }

  /** Shows which country somebody has chosen and, if nobody has, which the word has drawn. */
  show(values: Values, asked: Values): void {
    const chosen = this.#find(asked.get(COUNTRY));
    this.#buttons.press(chosen, chosen === BY_THE_WORD ? this.#find(values.get(COUNTRY)) : undefined);
  }

  #find(wanted: string | undefined): Country | undefined {
    return this.#all.find(({ name }) => name === wanted);
  }
}

/** Returns what goes to a country: its name, and nothing said of what a country decides but of what is kept. */
export function goingTo(
  { name }: Country,
  table: readonly Parameter[],
  kept: ReadonlySet<string>,
): readonly (readonly [key: string, value: string])[] {
  const left = table.filter(({ key, decided }) => decided && !kept.has(key));
  return [[COUNTRY, name], ...left.map(({ key }): [string, string] => [key, AUTO])];
}
