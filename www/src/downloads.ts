/** The download menu: one file at a time, and word of how it went. */

import { named, type PageError } from "./errors.ts";
import { type Format, fileOf, isFormat } from "./files.ts";
import { Menu } from "./menu.ts";
import type { Recipe } from "./recipe.ts";
import { fileName, save } from "./share.ts";
import type { Core } from "./wasm.ts";

export interface DownloadParts {
  download: HTMLButtonElement;
  formats: HTMLElement;
  /** Where is said what happens. */
  shared: HTMLElement;
}

export class Downloads {
  #isBusy = false;

  constructor(
    private readonly parts: DownloadParts,
    private readonly core: Core,
    private readonly recipe: Recipe,
    private readonly failed: (error: PageError) => void,
  ) {
    new Menu(parts.download, parts.formats, ({ dataset }) => {
      if (isFormat(dataset["format"]) && !this.#isBusy) void this.#download(dataset["format"]);
    });
  }

  async #download(format: Format): Promise<void> {
    const { link, seed } = this.recipe;
    const name = fileName(seed, format);
    this.#isBusy = true;
    this.parts.shared.textContent = `Making ${name}…`;
    try {
      save(await fileOf(this.core, link, format), name);
      this.parts.shared.textContent = `${name} is in your downloads.`;
    } catch (thrown) {
      const error = named(thrown);
      this.parts.shared.textContent = `${name} could not be made: ${error.message}`;
      if (error.code === "panic") this.failed(error);
    } finally {
      this.#isBusy = false;
    }
  }
}
