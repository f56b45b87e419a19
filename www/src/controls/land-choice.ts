/**
 * The choice of land that is always in reach. “Drawn” appears only for a drawn land, since drawing has its own button.
 */

import { el, setValue } from "../browser/dom.ts";
import type { Parameter } from "../engine/table.ts";

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
