/** Connects the names on the map, which the viewport provides, with their list in the panel, which changes them. */

import { named } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import { isRiver } from "../look-inside/river-pointer.ts";
import type { RiverViewport } from "../map/viewport.ts";
import { type Named, NameList, namedOf } from "./name-list.ts";

export interface MapNamesEvents {
  /** Called with the parameter `names` when the visitor has renamed something. */
  changed(names: string): void;
  /** Called when a text cannot be a name, with a sentence that says why. */
  refused(message: string): void;
}

/** The number of rivers in the panel's list. */
const NAMED_RIVERS = 12;

export class MapNames {
  readonly list = new NameList({
    names: () => this.#all(),
    rename: (mark, name) => void this.#rename(mark, name),
  });

  constructor(
    private readonly viewport: RiverViewport,
    private readonly recipe: Recipe,
    private readonly events: MapNamesEvents,
  ) {}

  /** Returns the marks of the greatest rivers, the greatest first. */
  async greatest(): Promise<string[]> {
    return (await this.#all()).map(({ mark }) => mark).filter(isRiver);
  }

  /**
   * Puts the names of the finished map into the list. Returns them if the map has labels and is still the one on show.
   */
  async refresh(): Promise<readonly Named[]> {
    const isLabelled = this.recipe.values.get("labels") !== "none";
    if (!isLabelled && !this.list.isShown) return [];
    const { link } = this.recipe;
    const names = await this.#all();
    if (link !== this.recipe.link || this.viewport.state !== "finished") return [];
    this.list.refresh(names);
    return isLabelled ? names : [];
  }

  /**
   * Returns the names of the finished map, great rivers first; none if they cannot be loaded, which the viewport
   * reports.
   */
  async #all(): Promise<Named[]> {
    try {
      return namedOf(await this.viewport.names(NAMED_RIVERS));
    } catch {
      return [];
    }
  }

  /** Gives something on the map another name, or its usual one. */
  async #rename(mark: string, name: string | undefined): Promise<void> {
    try {
      this.events.changed(await this.viewport.renamed(() => this.recipe.values.get("names") ?? "", mark, name));
    } catch (thrown) {
      this.events.refused(named(thrown).message);
      this.list.restore();
    }
  }
}
