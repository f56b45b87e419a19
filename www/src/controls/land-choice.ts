/** The kind of land, where it is always at hand. A drawn one is drawn first: that has a button of its own. */

import { el, setValue } from "../browser/dom.ts";
import type { Parameter } from "../engine/full.ts";

const DRAWN = "drawn";

export class LandChoice {
  readonly #drawn = el("option", { value: DRAWN, hidden: true });

  constructor(
    private readonly select: HTMLSelectElement,
    land: Parameter | undefined,
    choose: (land: string) => void,
  ) {
    const options = (land?.choices ?? []).map(({ value, label }) => {
      if (value !== DRAWN) return el("option", { value }, label);
      this.#drawn.textContent = label;
      return this.#drawn;
    });
    select.replaceChildren(...options);
    select.addEventListener("change", () => choose(select.value));
  }

  show(land: string): void {
    this.#drawn.hidden = land !== DRAWN;
    setValue(this.select, land);
  }
}
