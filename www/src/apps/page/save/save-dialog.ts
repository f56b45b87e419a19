/** The Save dialog: the kind of file, its size and background, and its progress. */

import { el } from "../../../browser/dom.ts";
import type { Keeper } from "../../../controls/disclosure.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import { FORMATS, type Format, isFormat } from "../../../files/format-names.ts";
import { OWN_SIZES, SHEETS, SIZES } from "../../../files/order.ts";
import type { Asker, Downloads } from "./downloads.ts";
import { KINDS, type Kind, ownSizeOf, RASTER_SIZES, SaveChoices, SIZE_NAMES, type SizeName } from "./save-choices.ts";

export interface SaveElements {
  dialog: HTMLDialogElement;
  /** Opens the dialog. */
  open: HTMLButtonElement;
  close: HTMLButtonElement;
  form: HTMLFormElement;
  /** The place of messages; below, the one that is used while the dialog is closed. */
  status: HTMLElement;
  elsewhere: HTMLElement;
}

/** The name and the use of pictures and videos; `FORMATS` has those of other files. */
const WORDS: Record<Exclude<Kind, Format>, readonly [name: string, help: string]> = {
  png: ["Picture (PNG)", "for screens, print and posters"],
  card: ["Card (PNG)", "1200 × 630 with the map’s title, for posts"],
  animation: ["Animation", "the growth as a video of six seconds"],
};

/** The text for an animation if the browser gives pages no encoder, or none without a secure connection. */
const NO_ENCODER = "not available: this browser does not let this page encode video";

const SIZE_WORDS: Record<SizeName, string> = {
  screen: `Screen: ${SIZES.screen}`,
  a4: paper("a4"),
  a3: paper("a3"),
  poster: `Poster, ${paper("poster")}`,
  own: "Own size",
};

/** Returns the words for a sheet of paper, as in "A4, 300 dpi: 3508 × 2480". */
function paper(size: keyof typeof SIZES): string {
  const { paper = "", shorterSide = 0, dpi = 0 } = SHEETS[size] ?? {};
  return `${paper}, ${Math.round(dpi)} dpi: ${SIZES[size]} × ${shorterSide}`;
}

const SIZE_HELP = "longer side first, in pixels; on paper, sea or paper of the style fills the sheet";

const TRANSPARENT_HELP =
  "Transparent leaves the sea out; land, rivers and names stay. In the styles ink, dark and skeleton the paper goes, and lines stay.";

/** The files with names that can be left out; below, those with a background and a size. */
const WITH_NAMES: readonly Kind[] = ["png", "svg"];
const WITH_SIZE: readonly Kind[] = ["png"];

const RASTER_HELP =
  "Pixels of heights, masks and flow. A square has the map in its middle and sea around it. The largest may take a minute.";

export class SaveDialog {
  readonly #choices: SaveChoices;
  readonly #kinds = radios(
    "save-kind",
    "File",
    KINDS.map((kind) => [kind, ...(isFormat(kind) ? FORMATS[kind].words : WORDS[kind])]),
  );
  readonly #size = el("select", { id: "save-size" });
  readonly #own = el("input", {
    id: "save-own",
    type: "number",
    inputmode: "numeric",
    ...OWN_SIZES,
    "aria-describedby": "save-own-help",
  });
  readonly #ownRow: HTMLElement;
  readonly #ground = radios("save-ground", "Ground", [
    ["paper", "Paper", ""],
    ["transparent", "Transparent", ""],
  ]);
  readonly #rasterSize = radios(
    "save-raster",
    "Longer side",
    RASTER_SIZES.map((size) => [String(size), String(size), ""]),
  );
  readonly #rasterShape = radios("save-shape", "Shape", [
    ["map", "The map’s", ""],
    ["square", "Square", ""],
  ]);
  readonly #rastered = el(
    "div",
    { class: "save-options" },
    this.#rasterSize.element,
    this.#rasterShape.element,
    el("p", { class: "help" }, RASTER_HELP),
  );
  readonly #names = el("input", { id: "save-names", type: "checkbox", "aria-describedby": "save-names-help" });
  readonly #namesHelp = el("span", { class: "help", id: "save-names-help" });
  readonly #sized: HTMLElement;
  readonly #named: HTMLElement;
  readonly #save = el("button", { type: "submit", class: "act", id: "save-file" }, "Save");
  readonly #cancel = el("button", { type: "button", id: "save-cancel", hidden: true }, "Cancel");
  readonly #progress = el("progress", { max: 1, hidden: true, "aria-label": "How far the file is" });
  readonly #percent = el("span", { class: "percent", "aria-hidden": "true" });

  constructor(
    private readonly elements: SaveElements,
    private readonly recipe: Recipe,
    private readonly downloads: Downloads,
    keeper: () => Keeper,
  ) {
    this.#choices = new SaveChoices(keeper);
    if (!("VideoEncoder" in globalThis)) this.#kinds.refuse("animation", NO_ENCODER);
    this.#size.append(...SIZE_NAMES.map((name) => el("option", { value: name }, SIZE_WORDS[name])));
    const { min, max } = OWN_SIZES;
    this.#ownRow = row("save-own", "Longer side", this.#own, help("save-own-help", `pixels, ${min} to ${max}`));
    this.#sized = el(
      "div",
      { class: "save-options" },
      row("save-size", "Size", this.#size, el("span", { class: "help" }, SIZE_HELP)),
      this.#ownRow,
      this.#ground.element,
      el("p", { class: "help" }, TRANSPARENT_HELP),
    );
    this.#named = row("save-names", "With names", this.#names, this.#namesHelp);
    elements.form.replaceChildren(
      this.#kinds.element,
      this.#sized,
      this.#rastered,
      this.#named,
      el("div", { class: "save-end" }, this.#save, this.#cancel, this.#progress, this.#percent),
    );
    this.#listen();
  }

  #listen(): void {
    const { open, close, dialog, form } = this.elements;
    open.addEventListener("click", () => this.#open());
    close.addEventListener("click", () => dialog.close());
    form.addEventListener("input", () => this.#read());
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.#make();
    });
    this.#cancel.addEventListener("click", () => this.downloads.cancel());
  }

  #open(): void {
    if (this.#cancel.hidden) this.#say("");
    this.#show();
    this.elements.dialog.showModal();
  }

  /** Shows the choices. */
  #show(): void {
    const { kind, size, ownSize, isTransparent, hasNames, rasterSize, isSquare } = this.#choices.now;
    this.#kinds.value = kind;
    // A remembered choice may be refused now.
    if (this.#kinds.value === "") {
      this.#choices.set({ kind: "png" });
      this.#kinds.value = "png";
    }
    this.#size.value = size;
    this.#own.value = String(ownSize);
    this.#ground.value = isTransparent ? "transparent" : "paper";
    this.#rasterSize.value = String(rasterSize);
    this.#rasterShape.value = isSquare ? "square" : "map";
    this.#names.disabled = !this.#isNamed;
    this.#names.checked = hasNames && this.#isNamed;
    this.#namesHelp.textContent = this.#isNamed ? "" : "This map shows none. Labels, under Shape, adds them.";
    this.#suit();
  }

  /** Shows the options for this kind of file. */
  #suit(): void {
    const { kind, size } = this.#choices.now;
    this.#sized.hidden = !WITH_SIZE.includes(kind);
    this.#rastered.hidden = kind !== "zip";
    this.#named.hidden = !WITH_NAMES.includes(kind);
    this.#ownRow.hidden = size !== "own";
  }

  /** True if the map has labels or a title. */
  get #isNamed(): boolean {
    const { values } = this.recipe;
    const isTitled = !["auto", "none"].includes(values.get("cartouche") ?? "auto");
    return isTitled || (values.get("labels") ?? "none") !== "none";
  }

  /** Takes the choices from the form. A typed size is ignored until it is valid. */
  #read(): void {
    const ownSize = ownSizeOf(this.#own.value);
    this.#own.toggleAttribute("aria-invalid", false);
    this.#choices.set({
      kind: KINDS.find((kind) => kind === this.#kinds.value) ?? "png",
      size: SIZE_NAMES.find((name) => name === this.#size.value) ?? "screen",
      ...(ownSize === undefined ? {} : { ownSize }),
      isTransparent: this.#ground.value === "transparent",
      rasterSize: Number(this.#rasterSize.value),
      isSquare: this.#rasterShape.value === "square",
      ...(this.#names.disabled ? {} : { hasNames: this.#names.checked }),
    });
    this.#suit();
  }

  async #make(): Promise<void> {
    const { kind, size } = this.#choices.now;
    if (kind === "png" && size === "own" && ownSizeOf(this.#own.value) === undefined) {
      this.#refuseSize();
      return;
    }
    // The Save button is replaced by Cancel meanwhile, which also takes the focus.
    this.#become(true);
    await this.downloads.save({ ...this.#choices.now }, this.#asker);
    this.#become(false);
  }

  #refuseSize(): void {
    const { min, max } = OWN_SIZES;
    const typed = this.#own.value === "" ? "nothing" : this.#own.value;
    this.#say(`Longer side: ${typed} is not a whole number from ${min} to ${max} pixels.`);
    this.#own.setAttribute("aria-invalid", "true");
    this.#own.focus();
  }

  /** Shows or hides the progress of a file. */
  #become(isBusy: boolean): void {
    const hadFocus = [this.#save, this.#cancel].some((button) => button === document.activeElement);
    this.#save.hidden = isBusy;
    this.#cancel.hidden = this.#progress.hidden = !isBusy;
    if (!isBusy) this.#percent.textContent = "";
    if (hadFocus) (isBusy ? this.#cancel : this.#save).focus({ preventScroll: true });
  }

  readonly #asker: Asker = {
    say: (text) => this.#say(text),
    at: (share) => {
      if (share === undefined) this.#progress.removeAttribute("value");
      else this.#progress.value = share;
      this.#percent.textContent = share === undefined ? "" : `${Math.floor(share * 100)} %`;
    },
  };

  #say(text: string): void {
    const { dialog, status, elsewhere } = this.elements;
    status.textContent = text;
    if (!dialog.open && text !== "") elsewhere.textContent = text;
  }
}

interface Radios {
  readonly element: HTMLElement;
  value: string;
  /** Disables a choice and says why. */
  refuse(value: string, why: string): void;
}

/** Makes a group of radio buttons. */
function radios(
  name: string,
  legend: string,
  choices: readonly (readonly [value: string, name: string, help: string])[],
): Radios {
  const inputs = choices.map(([value]) => el("input", { type: "radio", name, value, id: `${name}-${value}` }));
  const labels = choices.map(([, word, help], i) =>
    el("label", {}, inputs[i] ?? "", el("b", {}, word), el("span", { class: "help", dir: "auto" }, help)),
  );
  return {
    element: el("fieldset", { class: name }, el("legend", {}, legend), ...labels),
    get value() {
      return inputs.find((input) => input.checked)?.value ?? "";
    },
    set value(value) {
      for (const input of inputs) input.checked = input.value === value && !input.disabled;
    },
    refuse(value, why) {
      for (const [i, input] of inputs.entries()) {
        if (input.value !== value) continue;
        input.disabled = true;
        labels[i]?.lastElementChild?.replaceChildren(why);
      }
    },
  };
}

function row(id: string, name: string, ...content: Node[]): HTMLElement {
  return el("div", { class: "save-row" }, el("label", { for: id }, name), ...content);
}

function help(id: string, text: string): HTMLElement {
  return el("span", { class: "help", id }, text);
}
