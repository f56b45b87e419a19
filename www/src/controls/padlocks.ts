/**
 * Padlocks: the values under a shut one are kept when a country, a pattern or a variation sets many at a time, or a word
 * decides them. Their state is remembered if the browser allows storage.
 */

import { el, icon } from "../browser/dom.ts";
import type { Keeper } from "./disclosure.ts";

const KEPT_AS = "riverseed-kept";

const DRAWING = "M4.500 7.500h7v6h-7zM5.500 7.500V5.500a2.500 2.500 0 0 1 5 0v2";

export class Padlocks {
  readonly #kept = new Set<string>();
  readonly #made: { button: HTMLElement; keys: readonly string[] }[] = [];
  /** The keys that were kept at the last visit. */
  readonly #remembered: ReadonlySet<unknown>;

  constructor(
    private readonly keeper: () => Keeper,
    /** Called when a padlock was shut. */
    private readonly shut: () => void = () => {},
  ) {
    this.#remembered = new Set(this.#read());
  }

  /** The keys whose values are kept. Each is under a padlock that shows it: nothing is kept unseen. */
  get kept(): ReadonlySet<string> {
    return this.#kept;
  }

  /**
   * Makes a padlock for some keys. It is shut when all of them are kept, and mixed when some are. Those that were kept
   * at the last visit are kept again.
   */
  padlock(label: string, keys: readonly string[]): HTMLElement {
    const title = `Keep ${label} when another word, country, preset or variation is chosen`;
    const attributes = { type: "button", class: "keep", "aria-label": `Keep ${label}`, title };
    const button = el("button", attributes, icon(DRAWING));
    button.addEventListener("click", () => this.#turn(keys));
    this.#made.push({ button, keys });
    for (const key of keys) if (this.#remembered.has(key)) this.#kept.add(key);
    this.#show();
    return button;
  }

  #turn(keys: readonly string[]): void {
    const isShut = keys.every((key) => this.#kept.has(key));
    for (const key of keys) {
      if (isShut) this.#kept.delete(key);
      else this.#kept.add(key);
    }
    this.#show();
    try {
      this.keeper().setItem(KEPT_AS, JSON.stringify([...this.#kept]));
    } catch {
      // The values are kept all the same, but the state is not remembered.
    }
    if (!isShut) this.shut();
  }

  #show(): void {
    for (const { button, keys } of this.#made) {
      const count = keys.filter((key) => this.#kept.has(key)).length;
      button.setAttribute("aria-pressed", count === 0 ? "false" : count === keys.length ? "true" : "mixed");
    }
  }

  #read(): readonly unknown[] {
    try {
      const kept: unknown = JSON.parse(this.keeper().getItem(KEPT_AS) ?? "[]");
      return Array.isArray(kept) ? kept : [];
    } catch {
      return [];
    }
  }
}
