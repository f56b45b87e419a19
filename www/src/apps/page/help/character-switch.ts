/** The switch in the help sheet that stops single characters from acting on the page. It is remembered. */

import { el } from "../../../browser/dom.ts";
import { guardCharacters, letCharactersAct } from "../../../browser/keys.ts";
import type { Keeper } from "../../../controls/disclosure.ts";

const KEPT_AS = "riverseed-single-keys";
const OFF = "off";

export class CharacterSwitch {
  readonly #box = el("input", { type: "checkbox", id: "single-keys", "aria-describedby": "single-keys-help" });
  readonly element = el(
    "p",
    { class: "switch" },
    this.#box,
    el("label", { for: "single-keys" }, "Single letters and signs are keys"),
    el(
      "span",
      { class: "help", id: "single-keys-help" },
      "A letter waits half a second, so that no word you type acts.",
    ),
  );

  constructor(private readonly keeper: () => Keeper) {
    this.#box.checked = !this.#isOff;
    this.#box.addEventListener("change", () => this.#keep());
    letCharactersAct(this.#box.checked);
    guardCharacters();
  }

  get #isOff(): boolean {
    try {
      return this.keeper().getItem(KEPT_AS) === OFF;
    } catch {
      return false;
    }
  }

  #keep(): void {
    letCharactersAct(this.#box.checked);
    try {
      this.keeper().setItem(KEPT_AS, this.#box.checked ? "on" : OFF);
    } catch {
      // The choice holds for this visit all the same.
    }
  }
}
