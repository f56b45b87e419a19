/** The Share dialog: a river as a link, an element, an iframe or a picture in Markdown, each to be copied. */

import { addressOf } from "../../../browser/address.ts";
import { el } from "../../../browser/dom.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { Downloads } from "../save/downloads.ts";
import { type Choices, FIRST } from "../save/save-choices.ts";
import { copy } from "./share.ts";
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

interface Form {
  name: string;
  /** What it is for. */
  help: string;
  /** `picture` is the name that its picture is saved as. */
  text(shared: Shared, picture: string): string;
  /** Whether it names a picture, which is to be saved. */
  takesPicture?: boolean;
}

/** What is saved from here: the map as a screen shows it, and its card. */
const PICTURE: Choices = { ...FIRST, kind: "png", size: "screen" };
const CARD: Choices = { ...FIRST, kind: "card" };

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
  text: elementSnippet,
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
  text: markdownSnippet,
  takesPicture: true,
};

export class ShareDialog {
  readonly #boxes = new Map<Form, HTMLTextAreaElement>();

  constructor(
    private readonly elements: ShareElements,
    private readonly recipe: Recipe,
    private readonly downloads: Downloads,
  ) {
    const forms = [LINK, ELEMENT, IFRAME, MARKDOWN].map((form) => this.#section(form));
    elements.forms.replaceChildren(...forms, this.#card());
    elements.open.addEventListener("click", () => this.#open());
    elements.close.addEventListener("click", () => elements.dialog.close());
  }

  #saveButton(): HTMLButtonElement {
    const save = el("button", { type: "button" }, "Save picture");
    save.addEventListener("click", () => void this.#save(PICTURE));
    return save;
  }

  async #save(choice: Choices): Promise<void> {
    await this.downloads.save(choice, { say: (text) => this.#say(text), at: () => {} });
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
    const picture = this.downloads.nameOf(PICTURE);
    for (const [form, box] of this.#boxes) box.value = form.text(shared, picture);
    this.#say(promiseFor(widgetNotices));
    this.elements.dialog.showModal();
  }

  /** No form of a link: what social networks show of one is the same for all of this page. */
  #card(): HTMLElement {
    const save = el("button", { type: "button" }, "Save card");
    save.addEventListener("click", () => void this.#save(CARD));
    const help =
      "A picture of 1200 × 630 with the map’s title, to post beside the link: a link by itself shows this page's picture, " +
      "since only a server could make one for each map.";
    return el(
      "section",
      {},
      el("h3", {}, "Card"),
      el("p", { class: "help" }, help),
      el("div", { class: "actions" }, save),
    );
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
