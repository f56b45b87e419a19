/** The names on the map, between the viewport, which makes them, and their list in the panel, which changes them. */

import { named } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import { isRiver } from "../look-inside/river-pointer.ts";
import type { RiverViewport } from "../map/viewport.ts";
import { type Named, NameList, namedOf } from "./name-list.ts";

export interface MapNamesEvents {
  /** Names of the visitor's own, as a link has them. */
  changed(names: string): void;
  /** Something cannot be a name, as a sentence says. */
  refused(message: string): void;
}

/** How many rivers have their names in the panel. */
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

  /** The marks of great rivers, the greatest first. */
  async greatest(): Promise<string[]> {
    return (await this.#all()).map(({ mark }) => mark).filter(isRiver);
  }

  /** The map is finished: its names go into the list. The answer is what its labels say, if it has any and is still the one on show. */
  async refresh(): Promise<readonly Named[]> {
    const isLabelled = this.recipe.values.get("labels") !== "none";
    if (!isLabelled && !this.list.isShown) return [];
    const { link } = this.recipe;
    const names = await this.#all();
    if (link !== this.recipe.link || this.viewport.state !== "finished") return [];
    this.list.refresh(names);
    return isLabelled ? names : [];
  }

  /** Those of the finished map, great rivers first; none if they cannot be had, as the viewport then says. */
  async #all(): Promise<Named[]> {
    try {
      return namedOf(await this.viewport.names(NAMED_RIVERS));
    } catch {
      return [];
    }
  }

  /** A name of the visitor's own for something on the map, or its usual one. */
  async #rename(mark: string, name: string | undefined): Promise<void> {
    try {
      this.events.changed(await this.viewport.renamed(() => this.recipe.values.get("names") ?? "", mark, name));
    } catch (thrown) {
      this.events.refused(named(thrown).message);
      this.list.restore();
    }
  }
}
