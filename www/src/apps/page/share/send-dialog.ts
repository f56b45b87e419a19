/**
 * Sends the country on show: its picture, a line and its link go to the system's share sheet. Where there is none, or
 * where the picture took longer than a press counts, a dialog shows the picture and what can be done with it.
 */

import { addressOf } from "../../../browser/address.ts";
import { copiesPictures, copy, copyPicture } from "../../../browser/clipboard.ts";
import { el } from "../../../browser/dom.ts";
import { named } from "../../../engine/errors.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { CountryName } from "../country-name.ts";
import type { Downloads } from "../save/downloads.ts";
import { FIRST } from "../save/save-choices.ts";
import { invitation } from "./invitation.ts";
import { type Message, send, takesPictures } from "./send.ts";
import { save } from "./share.ts";

export interface SendElements {
  dialog: HTMLDialogElement;
  /** Sends, or opens the dialog. */
  open: HTMLButtonElement;
  close: HTMLButtonElement;
  /** The place of the picture, and of the buttons. */
  content: HTMLElement;
  /** The place of messages; below, the one that is used while the dialog is closed. */
  status: HTMLElement;
  elsewhere: HTMLElement;
}

/** The file that is sent. */
const PORTRAIT = { ...FIRST, kind: "portrait" } as const;

const MAKING = "Making the picture…";

export class SendDialog {
  readonly #picture = el("img", { alt: "", width: 1200, height: 1500 });
  readonly #line = el("p", { class: "line", dir: "auto" });
  readonly #now = button("Send now", () => void this.#sendNow());
  readonly #link = button("Copy link", () => void this.#copyLink());
  readonly #copy = button("Copy picture", () => void this.#copyPicture());
  readonly #save = button("Save picture", () => this.#savePicture());
  /** The message that is being sent; below, whether its picture is being made. */
  #message: Message | undefined;
  #isBusy = false;

  constructor(
    private readonly elements: SendElements,
    private readonly recipe: Recipe,
    private readonly country: CountryName,
    private readonly downloads: Downloads,
  ) {
    const actions = el("div", { class: "actions" }, this.#now, this.#link, this.#copy, this.#save);
    elements.content.replaceChildren(
      el("div", { class: "preview" }, this.#picture),
      el("div", { class: "beside" }, this.#line, actions),
    );
    for (const foremost of [this.#now, this.#link]) foremost.className = "act";
    elements.open.addEventListener("click", () => void this.press());
    elements.close.addEventListener("click", () => elements.dialog.close());
    elements.dialog.addEventListener("close", () => this.#forget());
  }

  /** Returns whether the system has a share sheet that takes pictures. */
  get canSend(): boolean {
    return takesPictures(navigator);
  }

  /** Makes the picture and sends it. A press while one is being made does nothing. */
  async press(): Promise<void> {
    if (this.#isBusy) return;
    this.#isBusy = true;
    if (this.canSend) this.#say(MAKING);
    else this.#open();
    try {
      const message = await this.#make();
      if (this.elements.dialog.open) this.#show(message);
      else if (this.canSend) await this.#send(message);
    } catch (thrown) {
      this.#say(`The picture could not be made: ${named(thrown).message}`);
    } finally {
      this.#isBusy = false;
    }
  }

  async #make(): Promise<Message> {
    const { link, seed } = this.recipe;
    const [text, url] = [invitation(this.country.text, seed), addressOf(link, location.href)];
    const name = this.downloads.nameOf(PORTRAIT);
    const file = new File([await this.downloads.make(PORTRAIT)], name, { type: "image/png" });
    return { file, text, url };
  }

  async #send(message: Message): Promise<void> {
    const outcome = await send(message, navigator);
    this.#say("");
    if (outcome === "sent" || outcome === "cancelled") return;
    if (!this.elements.dialog.open) this.#open();
    this.#show(message);
    if (outcome === "late") this.#say("The picture is ready.");
    else this.#refuse();
  }

  async #sendNow(): Promise<void> {
    if (!this.#message) return;
    const outcome = await send(this.#message, navigator);
    if (outcome === "sent") this.elements.dialog.close();
    else if (outcome !== "cancelled") this.#refuse();
  }

  /** Leaves what needs no share sheet, since that took nothing. */
  #refuse(): void {
    this.#now.hidden = true;
    this.#say("The system did not take the picture. Copy or save it instead.");
  }

  /** Opens the dialog before the picture is made. */
  #open(): void {
    const { dialog } = this.elements;
    this.#now.hidden = true;
    this.#copy.hidden = !copiesPictures();
    this.#copy.disabled = this.#save.disabled = true;
    this.#picture.hidden = true;
    this.#line.textContent = invitation(this.country.text, this.recipe.seed);
    dialog.showModal();
    this.#say(MAKING);
  }

  #show(message: Message): void {
    this.#message = message;
    this.#picture.src = URL.createObjectURL(message.file);
    this.#picture.alt = `The picture: ${this.country.text}`;
    this.#picture.hidden = false;
    this.#line.textContent = message.text;
    this.#copy.disabled = this.#save.disabled = false;
    this.#now.hidden = !this.canSend;
    (this.canSend ? this.#now : this.#link).focus();
    this.#say("");
  }

  #forget(): void {
    URL.revokeObjectURL(this.#picture.src);
    this.#picture.removeAttribute("src");
    this.#message = undefined;
    this.elements.elsewhere.textContent = "";
  }

  async #copyLink(): Promise<void> {
    const url = this.#message?.url ?? addressOf(this.recipe.link, location.href);
    this.#say((await copy(url)) ? "Link copied." : `Copy this link: ${url}`);
  }

  async #copyPicture(): Promise<void> {
    if (!this.#message) return;
    const isCopied = await copyPicture(this.#message.file);
    this.#say(isCopied ? "Picture copied." : "The browser does not let this page copy pictures. Save it instead.");
  }

  #savePicture(): void {
    if (!this.#message) return;
    const { file } = this.#message;
    save(file, file.name);
    this.#say(`${file.name} is in your downloads.`);
  }

  #say(text: string): void {
    const { dialog, status, elsewhere } = this.elements;
    (dialog.open ? status : elsewhere).textContent = text;
  }
}

function button(name: string, press: () => void): HTMLButtonElement {
  const made = el("button", { type: "button" }, name);
  made.addEventListener("click", press);
  return made;
}
