/** The notices over the map: what had to be corrected in a link, what a preset changed unasked, and what failed. */

import type { Recipe } from "../../engine/recipe.ts";
import { elements } from "./elements.ts";
import type { PresetNote } from "./panel/preset-note.ts";
import { showNotices } from "./status.ts";

export class Notices {
  constructor(
    private readonly recipe: Recipe,
    private readonly presetNote: PresetNote,
  ) {}

  /** Shows what there is to say of the recipe on show. */
  show(): void {
    showNotices(elements.notices, [...this.recipe.notices.values(), ...this.presetNote.notes], () => {
      this.recipe.dismissNotices();
      this.presetNote.forget();
      this.show();
    });
  }

  /** Shows a message instead, until it is dismissed. */
  say(message: string): void {
    showNotices(elements.notices, [message], () => this.show());
  }
}
