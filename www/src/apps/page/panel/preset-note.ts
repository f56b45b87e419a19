/**
 * What presets changed unasked: a note says it, with the way back to before the preset, or to before the first of several. Any other change
 * makes it out of date.
 */

import { unaskedChanges } from "../../../controls/presets.ts";
import type { Parameter, Preset } from "../../../engine/full.ts";
import { undoable } from "../status.ts";

/** A recipe as it was. */
interface Before {
  link: string;
  values: ReadonlyMap<string, string>;
}

export class PresetNote {
  #last: (Before & { message: string }) | undefined;

  constructor(
    private readonly table: readonly Parameter[],
    /** Leads back to a link. */
    private readonly undo: (link: string) => void,
  ) {}

  /** One of some presets is pressed, and `set` changes the recipe to it from what it was before. */
  press(preset: Preset, all: readonly Preset[], { link, values }: Before, set: () => void): void {
    const before = this.#last ?? { link, values };
    const message = unaskedChanges(preset, all, this.table, before.values);
    set();
    this.#last = message === undefined ? undefined : { ...before, message };
  }

  forget(): void {
    this.#last = undefined;
  }

  /** The note, if there is anything to tell. */
  get notes(): HTMLElement[] {
    if (!this.#last) return [];
    const { message, link } = this.#last;
    return [undoable(message, "Undo", () => this.undo(link))];
  }
}
