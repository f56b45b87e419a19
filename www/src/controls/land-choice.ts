/**
 * The choice of land that is always in reach. “Drawn” appears only for a drawn land, since drawing has its own button.
 */

import type { Parameter } from "../engine/table.ts";
import { Choice } from "./choice.ts";

const DRAWN = "drawn";

export class LandChoice {
  readonly #choice: Choice;

  constructor(select: HTMLSelectElement, land: Parameter | undefined, choose: (land: string) => void) {
    this.#choice = new Choice(select, land, choose);
  }

  /** Shows a land. `automatic` is the one that the word has decided, if it is left to that. */
  show(land: string, automatic: string | undefined): void {
    const drawn = this.#choice.option(DRAWN);
    if (drawn) drawn.hidden = land !== DRAWN;
    this.#choice.show(land, automatic);
  }
}
