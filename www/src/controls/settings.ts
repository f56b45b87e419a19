/**
 * Every individual setting, folded away. Those without effect on the map on show are hidden: a line tells how many they are,
 * and a switch shows them with the reasons.
 */

import { el, setText } from "../browser/dom.ts";
import type { Disclosures } from "./disclosure.ts";
import type { Group } from "./group.ts";

const NAME = "All settings";
/** The name under which the state of the switch is remembered. */
const IDLE_NAME = "Settings without effect";

export class Settings {
  readonly element: HTMLDetailsElement;
  readonly #shown = el("input", { type: "checkbox", id: "show-idle" });
  readonly #count = el("span");
  readonly #line = el(
    "p",
    { class: "idle-line", hidden: true },
    this.#count,
    " ",
    el("label", { for: this.#shown.id }, this.#shown, "Show them, and why"),
  );
  #idle: ReadonlySet<string> = new Set();

  constructor(
    private readonly groups: readonly Group[],
    disclosures: Disclosures,
    /** Elements at the end, under no heading. */
    others: readonly HTMLElement[],
  ) {
    const summary = el("summary", {}, el("h2", {}, NAME));
    const content = el("div", {}, this.#line, ...groups.map(({ element }) => element), ...others);
    this.element = disclosures.details(NAME, false, { class: "group settings" }, summary, content);
    this.#shown.checked = disclosures.isOpen(IDLE_NAME, false);
    this.#shown.addEventListener("change", () => {
      disclosures.set(IDLE_NAME, this.#shown.checked);
      this.#hide();
    });
  }

  /** Follows which parameters have no effect. */
  show(idle: ReadonlySet<string>): void {
    this.#idle = idle;
    const { size } = idle;
    this.#line.hidden = size === 0;
    setText(
      this.#count,
      size === 1 ? "1 setting has no effect on this map." : `${size} settings have no effect on this map.`,
    );
    this.#hide();
  }

  #hide(): void {
    const hidden = this.#shown.checked ? new Set<string>() : this.#idle;
    for (const group of this.groups) group.hide(hidden);
  }
}
