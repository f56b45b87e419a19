/** The list of names on the map, each in its own field. A changed name becomes part of the link. */

import { el, setValue } from "../../../browser/dom.ts";
import type { Control } from "../../../controls/control.ts";
import { kindOf } from "../../../engine/mark.ts";
import type { NameFacts } from "../../../engine/types.ts";
import { wordFor } from "../naming/words.ts";

export interface NameListEvents {
  /** Returns the names on the map; none while it is not finished. */
  names(): Promise<readonly NameFacts[]>;
  /** Gives something another name, or its usual one. */
  rename(mark: string, name: string | undefined): void;
}

/** The number of rivers in the list, besides those with names of the visitor's. */
export const NAMED_RIVERS = 12;

const HELP = "help-names";

interface Row {
  readonly element: HTMLElement;
  readonly field: HTMLInputElement;
  /** Shows a name, unless somebody is typing in the field. */
  show(named: NameFacts, kind: string): void;
  restore(): void;
}

export class NameList implements Control {
  readonly element: HTMLElement;
  readonly #list = el("ul", { class: "names" });
  readonly #rows = new Map<string, Row>();
  #isSeen = false;

  constructor(private readonly events: NameListEvents) {
    const help = "Type over a name to change it. An empty name is not shown.";
    this.element = el("div", { class: "control", "data-key": "names", role: "group", "aria-label": "Names" });
    this.element.append(this.#list, el("p", { class: "help", id: HELP }, help));
    // Names are made each time, so only while the list is visible.
    new IntersectionObserver((entries) => {
      this.#isSeen = entries.at(-1)?.isIntersecting ?? false;
      if (this.#isSeen) void this.#ask();
    }).observe(this.element);
  }

  /** True while the list is visible. */
  get isShown(): boolean {
    return this.#isSeen;
  }

  /** Does nothing: the names follow when the rivers of the new recipe are finished. */
  show(): void {}

  /** Makes the names read-only until the rivers are finished. */
  hold(): void {
    for (const { field } of this.#rows.values()) field.readOnly = true;
  }

  /** Shows the names of finished rivers. */
  refresh(names: readonly NameFacts[]): void {
    // The map itself always has a name, so no names at all means that none are known.
    if (names.length === 0) return;
    for (const [mark, { element }] of this.#rows) {
      if (names.some((named) => named.mark === mark)) continue;
      element.remove();
      this.#rows.delete(mark);
    }
    let rivers = 0;
    names.forEach((named, i) => {
      const row = this.#rows.get(named.mark) ?? this.#row(named.mark);
      this.#rows.set(named.mark, row);
      const kind = kindOf(named.mark);
      row.show(named, kind === "river" ? riverOf(++rivers) : wordFor(kind));
      // Moved only if necessary, since moving takes the focus.
      if (this.#list.children[i] !== row.element) this.#list.insertBefore(row.element, this.#list.children[i] ?? null);
    });
  }

  /** Restores the names in all fields, since a typed text cannot be a name. */
  restore(): void {
    for (const row of this.#rows.values()) row.restore();
  }

  async #ask(): Promise<void> {
    this.refresh(await this.events.names());
  }

  #row(mark: string): Row {
    const kind = el("span", { "aria-hidden": "true" });
    const field = el("input", { type: "text", maxlength: 40, spellcheck: "false", "aria-describedby": HELP });
    const reset = el("button", { type: "button", class: "reset" }, "reset");
    let name = "";
    // The field's text when it was last shown or reported.
    let said = "";
    const restore = (): void => {
      said = name;
      setValue(field, name);
    };
    field.addEventListener("change", () => {
      said = field.value;
      if (field.value.trim() !== name) this.events.rename(mark, field.value.trim());
    });
    field.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || field.value === said) return;
      // Escape restores the name, and closes nothing.
      event.preventDefault();
      restore();
    });
    reset.addEventListener("click", () => {
      this.events.rename(mark, undefined);
      field.focus();
    });
    return {
      // As in "Silverrun, the greatest river".
      element: el("li", { "data-mark": mark }, field, kind, reset),
      field,
      restore,
      show(named, word) {
        const isTyping = document.activeElement === field && field.value !== said;
        name = named.name;
        if (!isTyping) restore();
        field.readOnly = false;
        field.setAttribute("aria-label", word.charAt(0).toUpperCase() + word.slice(1));
        kind.textContent = word;
        reset.hidden = !named.isOwn;
        reset.setAttribute("aria-label", `Reset ${name === "" ? word : name}`);
      },
    };
  }
}

/** Returns the word for a river by its rank. Those after the greatest are listed for their own names, whatever their rank. */
function riverOf(rank: number): string {
  if (rank === 1) return "the greatest river";
  if (rank > NAMED_RIVERS) return "smaller river";
  return `${rank}${rank === 2 ? "nd" : rank === 3 ? "rd" : "th"} greatest river`;
}
