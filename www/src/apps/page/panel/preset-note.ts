/**
 * The note on values that presets changed unasked, with a button that goes back to before the preset, or before the
 * first of several. Any other change removes it.
 */

import { unaskedChanges } from "../../../controls/presets.ts";
import type { Parameter, Preset } from "../../../engine/table.ts";
import { undoable } from "../status.ts";

/** The recipe from before a preset. */
interface Before {
  link: string;
  values: ReadonlyMap<string, string>;
}

export class PresetNote {
  #last: (Before & { message: string }) | undefined;

  constructor(
    private readonly table: readonly Parameter[],
    /** Goes back to a link. */
    private readonly undo: (link: string) => void,
  ) {}

  /** Takes the pressing of a preset out of `all`. `set` changes the recipe, which is given as it was before. */
  press(preset: Preset, all: readonly Preset[], { link, values }: Before, set: () => void): void {
    const before = this.#last ?? { link, values };
    const message = unaskedChanges(preset, all, this.table, before.values);
    set();
    this.#last = message === undefined ? undefined : { ...before, message };
  }

  forget(): void {
    this.#last = undefined;
  }

  /** The note, if there is one. */
  get notes(): HTMLElement[] {
    if (!this.#last) return [];
    const { message, link } = this.#last;
    return [undoable(message, "Undo", () => this.undo(link))];
  }
}
