/** Saves files of the rivers on show, one at a time, and reports their progress. */

import { named, PageError } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import { FORMATS, type Format, isFormat, type RasterOrder } from "../../../files/format-names.ts";
import { withoutNames } from "../../../files/order.ts";
import type { CountryName } from "../country-name.ts";
import { save } from "../share/share.ts";
import { fileName } from "./file-names.ts";
import { type Making, making } from "./making.ts";
import { type Choices, type FileChoices, type FileKind, longerSideOf, paperOf } from "./save-choices.ts";

export interface DownloadEvents {
  /** Makes a file of a link's finished rivers; `rasters` is for a game pack. */
  make(link: string, format: Format, rasters?: RasterOrder): Promise<Blob>;
  /** Called when the engine has stopped. */
  failed(error: PageError): void;
}

/** The part of the page that asked for a file. */
export interface Asker {
  say(text: string): void;
  /** Shows the progress of the file, from 0 to 1; undefined while it is not known. */
  at(share: number | undefined): void;
}

interface Naming {
  ending: string;
  details(style: string, choices: FileChoices): (string | number)[];
}

/** The details after the country's name in the names of pictures and videos, and their extension. */
const NAMES: Record<Exclude<FileKind, Format>, Naming> = {
  png: { ending: "png", details: (style, choices) => [style, sizeOf(choices)] },
  card: { ending: "png", details: (style) => [style, "card"] },
  portrait: { ending: "png", details: (style) => [style, "portrait"] },
  // The extension depends on the browser's encoder, and is corrected when the file is made.
  animation: { ending: "mp4", details: (style) => [style] },
};

/** The extensions of types that are not known beforehand. */
const ENDINGS: Readonly<Record<string, string>> = { "video/webm": "webm" };

export class Downloads {
  #making: Making | undefined;

  constructor(
    private readonly recipe: Recipe,
    private readonly country: CountryName,
    private readonly events: DownloadEvents,
  ) {}

  /** Returns the name of a file of the rivers on show. */
  nameOf(choices: FileChoices): string {
    const { ending, details } = namingOf(choices.kind);
    return fileName(
      this.country.text.toLowerCase(),
      ending,
      ...details(this.recipe.values.get("style") ?? "", choices),
    );
  }

  /**
   * Saves a file of the rivers on show, unless another one is still being made. Returns when it is saved or has failed.
   */
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

  /** Makes a file of the rivers on show that is not saved. Others may be in the making meanwhile. */
  async make(choices: FileChoices): Promise<Blob> {
    const file = await this.#begin(choices, { say: () => {}, at: () => {} }).file;
    if (!file) throw new PageError("unknown", "it was cancelled");
    return file;
  }

  /** Cancels the file that is being made, if any. */
  cancel(): void {
    this.#making?.cancel();
  }

  #begin(choices: FileChoices, asker: Asker): Making {
    const { kind, hasNames, isTransparent } = choices;
    const { shown } = this.recipe;
    const link = hasNames ? shown : withoutNames(shown);
    const tell = (share: number): void => asker.at(share);
    switch (kind) {
      case "png":
        return making(
          { kind: "picture", link, longerSide: longerSideOf(choices), ...paperOf(choices), isTransparent },
          tell,
        );
      case "card":
      case "portrait":
      case "animation":
        return making({ kind, link: shown }, tell);
      case "svg":
        return this.#inRenderer(link, kind);
      case "zip":
        return this.#inRenderer(shown, kind, { longerSide: choices.rasterSize, isSquare: choices.isSquare });
      default:
        return this.#inRenderer(shown, kind);
    }
  }

  /** Makes a file in the renderer, from the rivers on show. It takes only a moment, since they need not grow again. */
  #inRenderer(link: string, format: Format, rasters?: RasterOrder): Making {
    const control = new AbortController();
    const cancelled = new Promise<undefined>((done) => control.signal.addEventListener("abort", () => done(undefined)));
    const made = this.events.make(link, format, rasters).catch((thrown: unknown) => {
      const error = named(thrown);
      if (error.code === "panic") this.events.failed(error);
      throw error;
    });
    return { file: Promise.race([made, cancelled]), cancel: () => control.abort() };
  }
}

/** Returns what the name of a file of this kind has besides the country. */
function namingOf(kind: FileKind): Naming {
  if (!isFormat(kind)) return NAMES[kind];
  return { ending: kind, details: (style) => (FORMATS[kind].isStyled ? [style] : []) };
}

/** Returns the size of a picture as its file's name has it: that of a sheet of paper, or pixels. */
function sizeOf(choices: FileChoices): string | number {
  const { size } = choices;
  return size === "a4" || size === "a3" ? size : longerSideOf(choices);
}

/** Returns a file name with the extension of its type. */
function endedFor(name: string, type: string): string {
  const ending = ENDINGS[type.replace(/;.*/, "")];
  return ending === undefined ? name : name.replace(/[^.]+$/, ending);
}
