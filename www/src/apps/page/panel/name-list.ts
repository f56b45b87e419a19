/** The names of the map on show, each in a field of its own: whoever types over one has it in the link. */

import { el, setValue } from "../../../browser/dom.ts";
import type { Control } from "../../../controls/control.ts";

/** What has a name: its mark in links, the name, and whether that is the visitor's own. */
export interface Named {
  mark: string;
  name: string;
  isOwn: boolean;
}

export interface NameListEvents {
  /** The names on the map; none while there is no finished one. */
  names(): Promise<readonly Named[]>;
  /** Gives something another name, or its usual one. */
  rename(mark: string, name: string | undefined): void;
}

const KINDS: Record<string, string> = { t: "Map", s: "Sea", l: "Lake", i: "Island", m: "Meanders" };
const HELP = "help-names";

interface Row {
  readonly element: HTMLElement;
  readonly field: HTMLInputElement;
  /** Shows a name; a field in which somebody types keeps what is typed. */
  show(named: Named, kind: string): void;
  restore(): void;
}

export class NameList implements Control {
  readonly element: HTMLElement;
  readonly #list = el("ul", { class: "names" });
  readonly #rows = new Map<string, Row>();
  #isSeen = false;

  constructor(private readonly events: NameListEvents) {
    const help = "Type over a name to give one of your own; empty, it is not shown.";
    this.element = el("div", { class: "control", "data-key": "names", role: "group", "aria-label": "Names" });
    this.element.append(this.#list, el("p", { class: "help", id: HELP }, help));
    // Names are made each time, so not while nobody looks.
    new IntersectionObserver((entries) => {
      this.#isSeen = entries.at(-1)?.isIntersecting ?? false;
      if (this.#isSeen) void this.#ask();
    }).observe(this.element);
  }

  /** Whether anybody can look at it. */
  get isShown(): boolean {
    return this.#isSeen;
  }

  /** The recipe has other values: its names follow when its rivers are finished. */
  show(): void {}

  /** Rivers are on their way: until they are there, names stay as they are. */
  hold(): void {
    for (const { field } of this.#rows.values()) field.readOnly = true;
  }

  /** The rivers are finished. */
  refresh(names: readonly Named[]): void {
    // The map has a name always: without it, nothing is known.
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
      row.show(named, KINDS[named.mark.charAt(0)] ?? `River ${++rivers}`);
      // Moved only if it must be: that would take the focus.
      if (this.#list.children[i] !== row.element) this.#list.insertBefore(row.element, this.#list.children[i] ?? null);
    });
  }

  /** What is typed cannot be a name: back to what is one. */
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
    // What the field had when it was last shown, or said.
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
      // It takes back what is typed, and closes nothing.
      event.preventDefault();
      restore();
    });
    reset.addEventListener("click", () => {
      this.events.rename(mark, undefined);
      field.focus();
    });
    return {
      element: el("li", { "data-mark": mark }, kind, field, reset),
      field,
      restore,
      show(named, word) {
        const isTyping = document.activeElement === field && field.value !== said;
        name = named.name;
        if (!isTyping) restore();
        field.readOnly = false;
        field.setAttribute("aria-label", word);
        kind.textContent = word;
        reset.hidden = !named.isOwn;
        reset.setAttribute("aria-label", `Reset ${name === "" ? word : name}`);
      },
    };
  }
}

/** What the engine says of names, three texts each. */
export function namedOf(texts: readonly string[]): Named[] {
  return texts.flatMap((mark, i) =>
    i % 3 === 0 ? [{ mark, name: texts[i + 1] ?? "", isOwn: texts[i + 2] === "own" }] : [],
  );
}
