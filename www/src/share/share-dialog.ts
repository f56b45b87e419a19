/** The Share dialog: a river as a link, an element, an iframe or a picture in Markdown, each to be copied. */

import { addressOf } from "../browser/address.ts";
import { el } from "../browser/dom.ts";
import type { Recipe } from "../engine/recipe.ts";
import { copy, fileName } from "./share.ts";
import { elementSnippet, iframeSnippet, markdownSnippet, type Shared } from "./snippets.ts";

export interface ShareElements {
  dialog: HTMLDialogElement;
  /** Opens the dialog. */
  open: HTMLButtonElement;
  close: HTMLButtonElement;
  /** Takes the forms. */
  forms: HTMLElement;
  /** Where it is announced what happens. */
  status: HTMLElement;
}

/** Saves the picture of what is shown, and says how it goes. */
export type SavePicture = (say: (text: string) => void) => void;

interface Form {
  name: string;
  /** What it is for. */
  help: string;
  text(shared: Shared): string;
  /** Whether it names a picture, which is to be saved. */
  takesPicture?: boolean;
}

const LINK: Form = {
  name: "link",
  help: "Opens this page with these very rivers, for a message or a bookmark.",
  text: ({ link, page }) => addressOf(link, page),
};

const ELEMENT: Form = {
  name: "element",
  help:
    "Grows the rivers within your own page, where it may load scripts. For several, the first line is needed once. Save the " +
    "picture beside your text: it is seen until the rivers come, and where they cannot.",
  text: (shared) => elementSnippet(shared, pictureOf(shared)),
  takesPicture: true,
};

const IFRAME: Form = {
  name: "iframe",
  help: "Grows the rivers in a frame, where a page takes no scripts of others.",
  text: iframeSnippet,
};

const MARKDOWN: Form = {
  name: "Markdown",
  help: "A still picture that leads here, for a README or a forum. Save the picture beside your text.",
  text: (shared) => markdownSnippet(shared, pictureOf(shared)),
  takesPicture: true,
};

/** Under the name that the browser saves it as. */
function pictureOf({ seed }: Shared): string {
  return fileName(seed, "png");
}

export class ShareDialog {
  readonly #boxes = new Map<Form, HTMLTextAreaElement>();

  constructor(
    private readonly elements: ShareElements,
    private readonly recipe: Recipe,
    private readonly savePicture: SavePicture,
  ) {
    elements.forms.replaceChildren(...[LINK, ELEMENT, IFRAME, MARKDOWN].map((form) => this.#section(form)));
    elements.open.addEventListener("click", () => this.#open());
    elements.close.addEventListener("click", () => elements.dialog.close());
  }

  #saveButton(): HTMLButtonElement {
    const save = el("button", { type: "button" }, "Save picture");
    save.addEventListener("click", () => this.savePicture((text) => this.#say(text)));
    return save;
  }

  #section(form: Form): HTMLElement {
    const { name, help } = form;
    const ids = { box: `share-${name}`, help: `share-${name}-help` };
    const box = el("textarea", {
      class: "snippet",
      rows: 2,
      readonly: true,
      spellcheck: "false",
      id: ids.box,
      "aria-describedby": ids.help,
    });
    const copy = el("button", { type: "button", autofocus: form === LINK }, `Copy ${name}`);
    copy.addEventListener("click", () => void this.#copy(form, box));
    this.#boxes.set(form, box);
    return el(
      "section",
      {},
      el("h3", {}, el("label", { for: ids.box }, headed(name))),
      el("p", { class: "help", id: ids.help }, help),
      el("div", { class: "actions" }, copy, ...(form.takesPicture ? [this.#saveButton()] : [])),
      box,
    );
  }

  #open(): void {
    const { link, seed, values, widgetNotices } = this.recipe;
    const shared = { link, seed, aspect: values.get("aspect") ?? "", page: location.href };
    for (const [form, box] of this.#boxes) box.value = form.text(shared);
    this.#say(promiseFor(widgetNotices));
    this.elements.dialog.showModal();
  }

  async #copy({ name }: Form, box: HTMLTextAreaElement): Promise<void> {
    if (await copy(box.value)) {
      this.#say(`${headed(name)} copied.`);
    } else {
      box.focus();
      box.select();
      this.#say("The browser does not let this page copy. The text is selected, for you to copy it.");
    }
  }

  #say(text: string): void {
    this.elements.status.textContent = text;
  }
}

/** A widget does not grow all that the page does, and then its rivers are others. */
function promiseFor(notices: readonly string[]): string {
  if (notices.length === 0) return "Everyone who opens one of these sees the same rivers, to the bit.";
  return `As an element or an iframe these will be other rivers: ${notices.join("; ")}.`;
}

function headed(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
