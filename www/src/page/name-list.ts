/** The names of the map on show, each in a field of its own: whoever types over one has it in the link. */

import { el, setValue } from "../browser/dom.ts";
import type { Control } from "../controls/control.ts";

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

interface Row {
  readonly element: HTMLElement;
  show(named: Named): void;
}

export class NameList implements Control {
  readonly element: HTMLElement;
  readonly #list = el("ul", { class: "names" });
  readonly #rows = new Map<string, Row>();
  #asked = 0;

  constructor(private readonly events: NameListEvents) {
    const help = el("p", { class: "help" }, "Type over a name to give one of your own; empty, it is not shown.");
    this.element = el("div", { class: "control", "data-key": "names", role: "group", "aria-label": "Names" });
    this.element.append(this.#list, help);
    // Made of rivers each time, so not while nobody looks.
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) void this.refresh();
    }).observe(this.element);
  }

  /** The recipe has other values: its names follow when its rivers are finished. */
  show(): void {}

  /** The rivers are finished. */
  async refresh(): Promise<void> {
    const asked = ++this.#asked;
    if (!this.element.checkVisibility()) return;
    const names = await this.events.names();
    if (asked === this.#asked) this.#show(names);
  }

  #show(names: readonly Named[]): void {
    for (const mark of this.#rows.keys()) {
      if (names.some((named) => named.mark === mark)) continue;
      this.#rows.get(mark)?.element.remove();
      this.#rows.delete(mark);
    }
    names.forEach((named, i) => {
      const row = this.#rows.get(named.mark) ?? this.#row(named.mark);
      this.#rows.set(named.mark, row);
      row.show(named);
      // Moved only if it must be: that would take the focus.
      if (this.#list.children[i] !== row.element) this.#list.insertBefore(row.element, this.#list.children[i] ?? null);
    });
  }

  #row(mark: string): Row {
    const kind = KINDS[mark.charAt(0)] ?? "River";
    const field = el("input", { type: "text", maxlength: 40, spellcheck: false, "aria-label": kind });
    const reset = el("button", { type: "button", class: "reset" }, "reset");
    let name = "";
    field.addEventListener("change", () => {
      if (field.value.trim() !== name) this.events.rename(mark, field.value.trim());
    });
    field.addEventListener("keydown", ({ key }) => {
      if (key === "Escape") setValue(field, name);
    });
    reset.addEventListener("click", () => {
      this.events.rename(mark, undefined);
      field.focus();
    });
    return {
      element: el("li", {}, el("span", { "aria-hidden": "true" }, kind), field, reset),
      show(named) {
        name = named.name;
        setValue(field, name);
        reset.hidden = !named.isOwn;
        reset.setAttribute("aria-label", `The usual name in place of ${name === "" ? "none" : name}`);
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
