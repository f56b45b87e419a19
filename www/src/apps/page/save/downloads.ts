/** Files of the rivers on show, one at a time, and word of how it goes. */

import { named, type PageError } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { Format } from "../../../files/format-names.ts";
import { withoutNames } from "../../../files/order.ts";
import { save } from "../share/share.ts";
import { fileName } from "./file-names.ts";
import { type Making, making } from "./making.ts";
import { type Choices, type Kind, longerSideOf } from "./save-choices.ts";

export interface DownloadEvents {
  /** Makes a file of a link's finished rivers. */
  make(link: string, format: Format): Promise<Blob>;
  /** The engine has stopped. */
  failed(error: PageError): void;
}

/** Whoever asked for a file. */
export interface Asker {
  say(text: string): void;
  /** How far the file is, from 0 to 1; nothing while that is not known. */
  at(share: number | undefined): void;
}

/** How names of files go on after the seed, and how they end. */
const NAMES: Record<Kind, { ending: string; details(style: string, choices: Choices): (string | number)[] }> = {
  png: { ending: "png", details: (style, choices) => [style, longerSideOf(choices)] },
  svg: { ending: "svg", details: (style) => [style] },
  geojson: { ending: "geojson", details: () => [] },
  json: { ending: "json", details: () => [] },
  zip: { ending: "zip", details: (style) => [style] },
  card: { ending: "png", details: (style) => [style, "card"] },
  // As what, the browser's encoder says when it is made.
  animation: { ending: "mp4", details: (style) => [style] },
};

/** How files of a type end, where that is not known beforehand. */
const ENDINGS: Readonly<Record<string, string>> = { "video/webm": "webm" };

export class Downloads {
  #making: Making | undefined;

  constructor(
    private readonly recipe: Recipe,
    private readonly events: DownloadEvents,
  ) {}

  /** What a file of the rivers on show is called. */
  nameOf(choices: Choices): string {
    const { ending, details } = NAMES[choices.kind];
    return fileName(this.recipe.seed, ending, ...details(this.recipe.values.get("style") ?? "", choices));
  }

  /** Saves what is shown, unless another file is still being made. Returns when that is over. */
  async save(choices: Choices, asker: Asker): Promise<void> {
    if (this.#making) {
      asker.say("Another file is still being made.");
      return;
    }
    let name = this.nameOf(choices);
    asker.say(`Making ${choices.kind === "animation" ? "the animation" : name}…`);
    asker.at(undefined);
    try {
      this.#making = this.#begin(choices, asker);
      const file = await this.#making.file;
      if (file) {
        name = endedFor(name, file.type);
        save(file, name);
      }
      asker.say(file ? `${name} is in your downloads.` : `${name} was cancelled: nothing is saved.`);
    } catch (thrown) {
      asker.say(`${name} could not be made: ${named(thrown).message}`);
    } finally {
      this.#making = undefined;
    }
  }

  /** Stops what is being made, if anything is. */
  cancel(): void {
    this.#making?.cancel();
  }

  #begin(choices: Choices, asker: Asker): Making {
    const { kind, hasNames, isTransparent } = choices;
    const { shown } = this.recipe;
    const link = hasNames ? shown : withoutNames(shown);
    const tell = (share: number): void => asker.at(share);
    switch (kind) {
      case "png":
        return making({ kind: "picture", link, longerSide: longerSideOf(choices), isTransparent }, tell);
      case "card":
      case "animation":
        return making({ kind, link: shown }, tell);
      case "svg":
        return this.#inRenderer(link, kind);
      default:
        return this.#inRenderer(shown, kind);
    }
  }

  /** Of the very rivers on show, which need not grow again: it takes a moment. */
  #inRenderer(link: string, format: Format): Making {
    const control = new AbortController();
    const cancelled = new Promise<undefined>((done) => control.signal.addEventListener("abort", () => done(undefined)));
    const made = this.events.make(link, format).catch((thrown: unknown) => {
      const error = named(thrown);
      if (error.code === "panic") this.events.failed(error);
      throw error;
    });
    return { file: Promise.race([made, cancelled]), cancel: () => control.abort() };
  }
}

/** The name of a file with the ending that its type has. */
function endedFor(name: string, type: string): string {
  const ending = ENDINGS[type.replace(/;.*/, "")];
  return ending === undefined ? name : name.replace(/[^.]+$/, ending);
}
