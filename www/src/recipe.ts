/** The recipe on show, always in the core's own spelling: what the page changes, the core reads and answers. */

import type { Reading } from "../pkg/riverseed.js";
import { linkText } from "./link.ts";

export class Recipe {
  #link = "";
  #values = new Map<string, string>();
  #idle = new Map<string, string>();
  #notices = new Map<string, string>();

  constructor(private readonly read: (text: string) => Reading) {}

  /** Its canonical link. */
  get link(): string {
    return this.#link;
  }

  get values(): ReadonlyMap<string, string> {
    return this.#values;
  }

  /** Why keys do nothing, by key. */
  get idle(): ReadonlyMap<string, string> {
    return this.#idle;
  }

  /** What had to be clamped or left out, by the key it is about. */
  get notices(): ReadonlyMap<string, string> {
    return this.#notices;
  }

  get seed(): string {
    return this.#values.get("seed") ?? "";
  }

  /** Takes a whole link, from an address or a person. */
  open(text: string): void {
    this.#notices.clear();
    this.#take(this.read(text));
  }

  /** Changes some values. A note about another one stays until it is dismissed; one about these is out of date. */
  set(changes: Iterable<readonly [key: string, value: string]>): void {
    const values = new Map(this.#values);
    for (const [key, value] of changes) {
      values.set(key, value);
      this.#notices.delete(key);
    }
    this.#take(this.read(linkText(values)));
  }

  dismissNotices(): void {
    this.#notices.clear();
  }

  #take({ link, values, idle, notices }: Reading): void {
    this.#link = link;
    this.#values = new Map(values);
    this.#idle = new Map(idle);
    for (const { key, message } of notices) {
      const before = this.#notices.get(key);
      this.#notices.set(key, before ? `${before}; ${message}` : message);
    }
  }
}
