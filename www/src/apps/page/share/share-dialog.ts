/**
 * The Share dialog: a river as a link, an element, an iframe or a picture in Markdown, each with a button to copy it.
 */

import { addressOf } from "../../../browser/address.ts";
import { copy } from "../../../browser/clipboard.ts";
import { el } from "../../../browser/dom.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { Downloads } from "../save/downloads.ts";
import { type Choices, FIRST } from "../save/save-choices.ts";
import { elementSnippet, iframeSnippet, markdownSnippet, type Shared } from "./snippets.ts";

export interface ShareElements {
  dialog: HTMLDialogElement;
  /** Opens the dialog. */
  open: HTMLButtonElement;
  close: HTMLButtonElement;
  /** The place of the forms. */
  forms: HTMLElement;
  /** The place of messages. */
  status: HTMLElement;
}

interface Form {
  name: string;
  /** The help text, which says what the form is for. */
  help: string;
  /** Returns the text to copy. `picture` is the file name of the saved picture. */
  text(shared: Shared, picture: string): string;
  /** True if it refers to a picture, which has to be saved. */
  takesPicture?: boolean;
}

/** The files that are saved from here: the map at screen size, and its card. */
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
    "picture beside your text: it is shown until the rivers appear, and where they cannot.",
  text: elementSnippet,
  takesPicture: true,
};

const IFRAME: Form = {
  name: "iframe",
  help: "Grows the rivers in a frame, for pages that allow no scripts from other sites.",
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

  /**
   * Makes the section of the card. It is a file, since social networks show the same picture for all links of this
   * page.
   */
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

/** Says who sees the same rivers. A widget cannot grow everything that the page can, and then its rivers differ. */
function promiseFor(notices: readonly string[]): string {
  if (notices.length === 0) return "Everyone who opens one of these sees the same rivers, to the bit.";
  return `As an element or an iframe the rivers will be different: ${notices.join("; ")}.`;
}

function headed(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
