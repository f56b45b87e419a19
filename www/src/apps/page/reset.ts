/** The button that opens a word's own country, in the window's shape. It is there while there is something to reset. */

import { linkText } from "../../engine/link-text.ts";
import type { Recipe } from "../../engine/recipe.ts";
import { elements } from "./elements.ts";
import { shapeOfWindow } from "./preferences.ts";

export class Reset {
  constructor(
    private readonly recipe: Recipe,
    open: (link: string) => void,
  ) {
    elements.reset.addEventListener("click", () =>
      open(
        linkText([
          ["seed", recipe.seed],
          ["aspect", this.#usualAspect],
        ]),
      ),
    );
  }

  /** Follows a change of the recipe. */
  offer(): void {
    const { asked, defaults, seed } = this.recipe;
    const usual = new Map([...defaults, ["aspect", this.#usualAspect], ["seed", seed]]);
    const isUsual = [...usual].every(([key, text]) => asked.get(key) === text);
    const { reset, panel } = elements;
    if (isUsual && document.activeElement === reset) panel.close.focus();
    reset.hidden = isUsual;
  }

  get #usualAspect(): string {
    return shapeOfWindow(this.recipe.defaults.get("aspect") ?? "");
  }
}
