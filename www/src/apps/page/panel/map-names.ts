/** Connects the names on the map, which the viewport provides, with their list in the panel, which changes them. */

import { named } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { NameFacts } from "../../../engine/types.ts";
import { isRiver } from "../look-inside/river-pointer.ts";
import type { RiverViewport } from "../map/viewport.ts";
import { isOwnName } from "../naming/own-names.ts";
import { NAMED_RIVERS, NameList } from "./name-list.ts";

export interface MapNamesEvents {
  /** Called with the parameter `names` when the visitor has renamed something. */
  changed(names: string): void;
  /** Called when a text cannot be a name, with a sentence that says why. */
  refused(message: string): void;
}

export class MapNames {
  readonly list = new NameList({
    names: () => this.#all(),
    rename: (mark, name) => void this.#renameInList(mark, name),
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
  async refresh(): Promise<readonly NameFacts[]> {
    const isLabelled = this.recipe.values.get("labels") !== "none";
    if (!isLabelled && !this.list.isShown) return [];
    const { link } = this.recipe;
    const names = await this.#all();
    if (link !== this.recipe.link || this.viewport.state !== "finished") return [];
    this.list.refresh(names);
    return isLabelled ? names : [];
  }

  /**
   * Returns the names of the finished map, great rivers first; none if the engine does not answer, which the
   * viewport reports.
   */
  async #all(): Promise<readonly NameFacts[]> {
    try {
      return await this.viewport.ask.names(NAMED_RIVERS);
    } catch {
      return [];
    }
  }

  /** Returns whether the visitor gave something its name. */
  isOwn(mark: string): boolean {
    return isOwnName(this.#own, mark);
  }

  /** Gives something on the map another name, or its usual one. Rejects if that is not possible. */
  async rename(mark: string, name: string | undefined): Promise<void> {
    this.events.changed(await this.viewport.ask.renamed(() => this.#own, mark, name));
  }

  /** The names that the visitor gave, as a link has them. */
  get #own(): string {
    return this.recipe.values.get("names") ?? "";
  }

  async #renameInList(mark: string, name: string | undefined): Promise<void> {
    try {
      await this.rename(mark, name);
    } catch (thrown) {
      this.events.refused(named(thrown).message);
      this.list.restore();
    }
  }
}
