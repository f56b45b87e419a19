/** A button for each of some named things, of which at most one is pressed. */

import { el } from "../browser/dom.ts";

/** What a button stands for. */
export interface Named {
  readonly name: string;
  readonly label: string;
  readonly help: string;
}

/** Attributes of the pictures: the size is in CSS pixels, and they are fetched when they are about to be seen. */
const PICTURE = { width: "108", height: "68", loading: "lazy", decoding: "async" };

export class Buttons<Item extends Named> {
  readonly element: HTMLElement;
  readonly #made: { item: Item; button: HTMLButtonElement }[];
  #last: HTMLButtonElement | undefined;
  #areAllInSight: boolean;

  /**
   * Makes the buttons. `pictureOf` returns the address of a thing's picture, if it has one. `first` is the number of
   * things in sight before somebody asks for more.
   */
  constructor(
    name: string,
    all: readonly Item[],
    choose: (item: Item) => void,
    pictureOf: (item: Item) => string | undefined = () => undefined,
    private readonly first = all.length,
  ) {
    this.#areAllInSight = first >= all.length;
    this.#made = all.map((item) => {
      const src = pictureOf(item);
      const picture = src === undefined ? [] : [el("img", { src, alt: "", ...PICTURE })];
      const button = el("button", { type: "button", class: "preset", title: item.help }, ...picture, item.label);
      button.addEventListener("click", () => {
        this.#last = button;
        choose(item);
      });
      return { item, button };
    });
    const buttons = el("div", { class: "preset-buttons" }, ...this.#made.map(({ button }) => button));
    if (!this.#areAllInSight) buttons.append(this.#moreButton(name));
    this.element = el("div", { class: "presets", role: "group", "aria-label": name }, buttons);
    this.press(undefined);
  }

  /** Presses the button of one thing, or none. `marked` is another that is marked as what the pressed one has come to. */
  press(pressed: Item | undefined, marked?: Item): void {
    const isFar = ({ item }: { item: Item }, rank: number): boolean =>
      rank >= this.first && (item === pressed || item === marked);
    // What is pressed or marked takes the place of the last in sight.
    let left = this.#areAllInSight ? this.#made.length : this.first - this.#made.filter(isFar).length;
    for (const [rank, one] of this.#made.entries()) {
      const { item, button } = one;
      button.setAttribute("aria-pressed", String(item === pressed));
      if (item === marked) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
      button.hidden = !isFar(one, rank) && left-- <= 0;
    }
  }

  /** Makes the button that shows all, for good: whoever looks for one may look for another. */
  #moreButton(name: string): HTMLButtonElement {
    const more = el("button", { type: "button", class: "preset more-presets" }, `More ${name.toLowerCase()}`);
    more.addEventListener("click", () => {
      const hidden = this.#made.filter(({ button }) => button.hidden);
      this.#areAllInSight = true;
      for (const { button } of hidden) button.hidden = false;
      more.remove();
      hidden[0]?.button.focus();
    });
    return more;
  }

  /** Puts the focus on the button that was pressed last. */
  focus(): void {
    this.#last?.focus({ preventScroll: true });
  }
}
