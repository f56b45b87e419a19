/** Downloads: one file at a time, and word of how it went. */

import { Menu } from "../controls/menu.ts";
import { named, type PageError } from "../engine/errors.ts";
import type { Recipe } from "../engine/recipe.ts";
import { type Format, isFormat } from "../player/format-names.ts";
import { fileName, save } from "./share.ts";

export interface DownloadElements {
  download: HTMLButtonElement;
  formats: HTMLElement;
  /** Where it is announced what happens. */
  shared: HTMLElement;
}

export interface DownloadEvents {
  /** Makes a file of a link's finished rivers. */
  make(link: string, format: Format): Promise<Blob>;
  /** The engine has stopped. */
  failed(error: PageError): void;
}

export class Downloads {
  #isBusy = false;

  constructor(
    private readonly elements: DownloadElements,
    private readonly recipe: Recipe,
    private readonly events: DownloadEvents,
  ) {
    new Menu(elements.download, elements.formats, ({ dataset }) => {
      if (isFormat(dataset["format"])) void this.save(dataset["format"], (text) => this.#say(text));
    });
  }

  /** Saves what is shown, unless another file is still being made, and says how it goes. */
  async save(format: Format, say: (text: string) => void): Promise<void> {
    if (this.#isBusy) return;
    const { shown, seed } = this.recipe;
    const name = fileName(seed, format);
    this.#isBusy = true;
    say(`Making ${name}…`);
    try {
      save(await this.events.make(shown, format), name);
      say(`${name} is in your downloads.`);
    } catch (thrown) {
      const error = named(thrown);
      say(`${name} could not be made: ${error.message}`);
      if (error.code === "panic") this.events.failed(error);
    } finally {
      this.#isBusy = false;
    }
  }

  #say(text: string): void {
    this.elements.shared.textContent = text;
  }
}
