/** The part of the card in which something is named: a field with its name, and what else is at the same place. */

import { el, setText } from "../../../browser/dom.ts";
import type { Nameable } from "../../page-worker/protocol.ts";
import { choiceOf, wordFor } from "./words.ts";

export interface NameFormEvents {
  /** Called with a new name, or with nothing for the made-up one. */
  save(name: string | undefined): void;
  cancel(): void;
  /** Called when somebody begins to type a name. */
  begun(): void;
  /** Called when another of the things at the same place is meant. */
  choose(thing: Nameable): void;
}

export class NameForm {
  readonly #label = el("label", { for: "own-name" });
  readonly #field = el("input", {
    type: "text",
    id: "own-name",
    autocomplete: "off",
    autocapitalize: "words",
    enterkeyhint: "done",
    spellcheck: "false",
    dir: "auto",
    "aria-describedby": "own-name-said",
  });
  readonly #said = el("p", { class: "name-said", id: "own-name-said", role: "alert" });
  readonly #noRoom = el("p", { class: "name-said", hidden: true }, "This name has no room at this size; zoom in.");
  readonly #save = el("button", { type: "submit", class: "act" }, "Save");
  readonly #madeUp = el("button", { type: "button", class: "quiet" }, "Use the made-up name");
  readonly #rename = el("button", { type: "button", class: "act" }, "Rename");
  readonly #besides = el("p", { class: "name-besides" });
  readonly #form: HTMLFormElement;
  readonly #closed: HTMLElement;
  #name = "";

  constructor(private readonly events: NameFormEvents) {
    const cancel = (): HTMLElement => {
      const button = el("button", { type: "button" }, "Cancel");
      button.addEventListener("click", () => events.cancel());
      return button;
    };
    const close = el("button", { type: "button" }, "Close");
    close.addEventListener("click", () => events.cancel());
    this.#closed = el("div", { class: "name-acts" }, this.#rename, close);
    const acts = el("div", { class: "name-acts" }, this.#save, cancel(), this.#madeUp);
    this.#form = el("form", { class: "name-form", novalidate: true }, this.#label, this.#field, this.#said, acts);
    this.#form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#submit();
    });
    this.#madeUp.addEventListener("click", () => events.save(undefined));
    this.#rename.addEventListener("click", () => this.begin());
  }

  get elements(): HTMLElement[] {
    return [this.#noRoom, this.#closed, this.#form, this.#besides];
  }

  /** The typed name, if it is another than the present one. */
  get changed(): string | undefined {
    const typed = this.#field.value.trim();
    return this.#form.hidden || typed === this.#name ? undefined : typed;
  }

  /** Asks for the name of a thing, and says if the one that it was given is not on the picture; `others` are at the same place. */
  show(thing: Nameable, isOwn: boolean, hasRoom: boolean, others: readonly Nameable[]): void {
    this.#name = thing.name;
    this.#field.value = thing.name;
    setText(this.#label, `Name of this ${wordFor(thing.kind)}`);
    this.refuse("");
    this.#madeUp.hidden = !isOwn;
    this.#noRoom.hidden = hasRoom;
    this.#besides.hidden = others.length === 0;
    this.#besides.replaceChildren("Also here:", ...others.map((other) => this.#choice(other)));
    this.#form.hidden = true;
    this.#closed.hidden = false;
  }

  /** Opens the field, with its text selected: what is typed takes its place. */
  begin(): void {
    this.#form.hidden = false;
    this.#closed.hidden = true;
    this.events.begun();
    this.#field.focus({ preventScroll: true });
    this.#field.select();
  }

  /** Puts the focus on what opens the field: no keyboard covers half of a phone unasked. */
  focusRename(): void {
    this.#rename.focus({ preventScroll: true });
  }

  /** Says why a text cannot be a name. */
  refuse(message: string): void {
    setText(this.#said, message);
    this.#said.hidden = message === "";
    this.#field.toggleAttribute("aria-invalid", message !== "");
    if (message !== "") this.#field.setAttribute("aria-invalid", "true");
  }

  #submit(): void {
    const { changed } = this;
    if (changed === undefined) this.events.cancel();
    else this.events.save(changed);
  }

  #choice(thing: Nameable): HTMLElement {
    const button = el("button", { type: "button", class: "quiet", dir: "auto" }, choiceOf(thing));
    button.addEventListener("click", () => this.events.choose(thing));
    return button;
  }
}
