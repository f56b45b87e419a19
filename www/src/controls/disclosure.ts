/** Groups that open and close. Their state is remembered if the browser allows storage. */

import { el } from "../browser/dom.ts";

const KEPT_AS = "riverseed-folds";

/** The part of a browser's storage that the page uses. Every call may throw. */
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
      // The group opens and closes all the same, but its state is not remembered.
    }
  }

  /** Makes a group under a heading, open or closed as it was left; `first` is its initial state. */
  details(name: string, first: boolean, attributes: { class: string }, ...children: Node[]): HTMLDetailsElement {
    const element = el("details", { ...attributes, open: this.isOpen(name, first) }, ...children);
    // The event "toggle" comes a task later: a page that is left at once would keep the state before.
    new MutationObserver(() => {
      if (element.open !== this.isOpen(name, first)) this.set(name, element.open);
    }).observe(element, { attributeFilter: ["open"] });
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
