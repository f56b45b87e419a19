/** Groups that open and close: which of them are open is remembered, where the browser lets the page remember anything. */

import { el } from "../browser/dom.ts";

const KEPT_AS = "riverseed-folds";

/** What a page can keep; of a browser's storage, whose every use may throw, this much. */
export interface Keeper {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

export class Disclosures {
  readonly #states = new Map<string, boolean>();

  constructor(private readonly keeper: () => Keeper) {
    for (const [name, open] of Object.entries(this.#kept()))
      if (typeof open === "boolean") this.#states.set(name, open);
  }

  isOpen(name: string, first: boolean): boolean {
    return this.#states.get(name) ?? first;
  }

  set(name: string, open: boolean): void {
    this.#states.set(name, open);
    try {
      this.keeper().setItem(KEPT_AS, JSON.stringify(Object.fromEntries(this.#states)));
    } catch {
      // It opens and closes all the same; it will only not be remembered.
    }
  }

  /** A group under a heading, as it was left, or as it is at first. */
  details(name: string, first: boolean, attributes: { class: string }, ...children: Node[]): HTMLDetailsElement {
    const element = el("details", { ...attributes, open: this.isOpen(name, first) }, ...children);
    element.addEventListener("toggle", () => {
      if (element.open !== this.isOpen(name, first)) this.set(name, element.open);
    });
    return element;
  }

  #kept(): object {
    try {
      const kept: unknown = JSON.parse(this.keeper().getItem(KEPT_AS) ?? "{}");
      return typeof kept === "object" && kept !== null ? kept : {};
    } catch {
      return {};
    }
  }
}
