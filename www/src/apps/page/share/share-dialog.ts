/** The Share dialog: asks where the country is to be seen, and gives the one thing that is needed there. */

import { addressOf } from "../../../browser/address.ts";
import { copy } from "../../../browser/clipboard.ts";
import { el } from "../../../browser/dom.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { Downloads } from "../save/downloads.ts";
import { type Choices, FIRST } from "../save/save-choices.ts";
import { PLACES, type Place } from "./places.ts";
import {
  elementSnippet,
  embedAddress,
  iframeSnippet,
  markdownSnippet,
  type Shared,
  withoutDefaultStyle,
} from "./snippets.ts";

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

/** The sender of the country: the button *Send* and its dialog. */
export interface Sender {
  /** True if the system's share sheet takes pictures. */
  readonly canSend: boolean;
  press(): Promise<void>;
}

/** A text to copy. */
interface Form {
  /** The name of the text, in "Copy …" and "… copied". */
  name: string;
  /** Returns the text. `picture` is the file name of the saved picture. */
  text(shared: Shared, picture: string): string;
}

/** The files that are saved from here: the map at screen size, and its card. */
const PICTURE: Choices = { ...FIRST, kind: "png", size: "screen" };
const CARD: Choices = { ...FIRST, kind: "card" };

const LINK: Form = { name: "link", text: ({ link, page }) => addressOf(link, page) };
const SNIPPET: Form = { name: "snippet", text: elementSnippet };
const IFRAME: Form = { name: "iframe", text: iframeSnippet };
const ADDRESS: Form = { name: "address", text: embedAddress };
const MARKDOWN: Form = { name: "Markdown", text: markdownSnippet };

export class ShareDialog {
  readonly #boxes = new Map<Form, HTMLTextAreaElement>();
  readonly #sections = new Map<Place, HTMLElement>();
  readonly #send = button("Send with its picture", () => this.#leaveTo(() => void this.sender.press()));

  constructor(
    private readonly elements: ShareElements,
    private readonly recipe: Recipe,
    private readonly downloads: Downloads,
    private readonly sender: Sender,
    /** Returns the letters to carry along with a link of the map, once they are placed. */
    private readonly letters: (link: string) => Promise<string | undefined>,
  ) {
    const content: Record<Place, HTMLElement[]> = {
      message: [this.#text(LINK, this.#send)],
      blog: [this.#text(SNIPPET, this.#save("Save picture", PICTURE)), this.#otherBlogs()],
      notebook: [this.#text(ADDRESS)],
      readme: [this.#text(MARKDOWN, this.#save("Save picture", PICTURE))],
      print: [
        el(
          "div",
          { class: "actions" },
          button("Print…", () => this.#leaveTo(() => print())),
        ),
      ],
    };
    for (const [place, { help }] of PLACES)
      this.#sections.set(place, el("section", {}, el("p", { class: "help" }, help), ...content[place]));
    elements.forms.replaceChildren(this.#places(), ...this.#sections.values());
    elements.open.addEventListener("click", () => this.#open());
    elements.close.addEventListener("click", () => elements.dialog.close());
  }

  /** Makes the choice of the place. */
  #places(): HTMLElement {
    const choices = PLACES.map(([place, { name }]) => {
      const radio = el("input", { type: "radio", name: "share-place", value: place, checked: place === "message" });
      radio.addEventListener("change", () => this.#show(place));
      return el("label", {}, radio, name);
    });
    this.#show("message");
    return el("fieldset", { class: "places" }, el("legend", {}, "Where?"), ...choices);
  }

  #show(shown: Place): void {
    for (const [place, section] of this.#sections) section.hidden = place !== shown;
  }

  /** Makes a text with a button that copies it. */
  #text(form: Form, ...more: HTMLButtonElement[]): HTMLElement {
    const box = el("textarea", {
      class: "snippet",
      rows: 2,
      readonly: true,
      spellcheck: "false",
      "aria-label": headed(form.name),
    });
    this.#boxes.set(form, box);
    const copy = button(`Copy ${form.name}`, () => void this.#copy(form, box));
    copy.className = "act";
    copy.autofocus = form === LINK;
    return el("div", {}, box, el("div", { class: "actions" }, copy, ...more));
  }

  /** Makes what blogs need that take no scripts. */
  #otherBlogs(): HTMLElement {
    const help =
      "The iframe is for blogs that allow no scripts of other sites. Where nothing but pictures is allowed, as on Medium " +
      "and Substack, post the card with the link.";
    return el(
      "details",
      {},
      el("summary", {}, "My blog allows no scripts"),
      el("p", { class: "help" }, help),
      this.#text(IFRAME, this.#save("Save card", CARD)),
    );
  }

  #save(name: string, choices: Choices): HTMLButtonElement {
    return button(name, () => void this.downloads.save(choices, { say: (text) => this.#say(text), at: () => {} }));
  }

  /** Closes the dialog first: what follows is not about it. */
  #leaveTo(next: () => void): void {
    this.elements.dialog.close();
    next();
  }

  #open(): void {
    const { link, seed, values, defaults, widgetNotices } = this.recipe;
    const shared: Shared = {
      link,
      widgetLink: withoutDefaultStyle(link, defaults.get("style") ?? ""),
      seed,
      aspect: values.get("aspect") ?? "",
      page: location.href,
    };
    this.#write(shared);
    void this.#addLetters(shared);
    this.#send.hidden = !this.sender.canSend;
    this.#say(promiseFor(widgetNotices));
    this.elements.dialog.showModal();
  }

  #write(shared: Shared): void {
    const picture = this.downloads.nameOf(PICTURE);
    for (const [form, box] of this.#boxes) box.value = form.text(shared, picture);
  }

  /** Adds letters to what has been written, unless the dialog has been closed or the map has changed by then. */
  async #addLetters(shared: Shared): Promise<void> {
    const { link, widgetLink = link } = shared;
    const letters = await this.letters(widgetLink).catch(() => undefined);
    if (letters && this.elements.dialog.open && this.recipe.link === link) this.#write({ ...shared, letters });
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
  if (notices.length === 0) return "Everyone who opens it sees the same country.";
  return `On a blog or in a notebook the rivers will be different: ${notices.join("; ")}.`;
}

function button(name: string, press: () => void): HTMLButtonElement {
  const made = el("button", { type: "button" }, name);
  made.addEventListener("click", press);
  return made;
}

function headed(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
