/** The recipe on show, always in the core's spelling: the page changes values, and the core reads the new link once. */

import { AUTO, changed, linkText } from "./link-text.ts";
import type { Reading, ReadOptions } from "./types.ts";

export class Recipe {
  #reading: Reading;
  #values: ReadonlyMap<string, string> = new Map();
  #asked: ReadonlyMap<string, string> = new Map();
  #idle: ReadonlyMap<string, string> = new Map();
  readonly #notices = new Map<string, string>();
  /** Read on first use, so that the first picture need not wait for it. */
  #defaults: ReadonlyMap<string, string> | undefined;

  /** Takes the first link. On a dark page, a recipe without a chosen style is shown in the style for dark pages. */
  constructor(
    private readonly readLink: (text: string, options?: ReadOptions) => Reading,
    text = "",
    private readonly isOnDark: () => boolean = () => false,
  ) {
    this.#reading = this.#take(text);
  }

  /** The canonical link to share. It contains the style if one was chosen, even the default one. */
  get link(): string {
    return this.#reading.sharedLink;
  }

  /** The link of what is shown. */
  get shown(): string {
    return this.#reading.link;
  }

  /** The width of the map over its height. */
  get aspect(): number {
    return Number(this.#values.get("aspect"));
  }

  /** The values of what is shown, whoever decided them. */
  get values(): ReadonlyMap<string, string> {
    return this.#values;
  }

  /** The values that the link names, and `auto` for each key that the word decides. */
  get asked(): ReadonlyMap<string, string> {
    return this.#asked;
  }

  /** The values of a link that says nothing, on this page. */
  get defaults(): ReadonlyMap<string, string> {
    this.#defaults ??= askedBy(this.#readHere(""));
    return this.#defaults;
  }

  /** The reason why a key has no effect, by key. */
  get idle(): ReadonlyMap<string, string> {
    return this.#idle;
  }

  /** Notices about values that had to be clamped or left out, by key. */
  get notices(): ReadonlyMap<string, string> {
    return this.#notices;
  }

  /** Sentences about the parts of the recipe that a widget does not grow. */
  get widgetNotices(): string[] {
    return this.readLink(this.link, { widget: true }).notices.map(({ message }) => message);
  }

  get seed(): string {
    return this.#values.get("seed") ?? "";
  }

  /** Takes a whole link, from an address or a person. */
  open(text: string): void {
    this.#notices.clear();
    this.#take(text);
  }

  /** Goes back to what is shown. A style that nobody chose is left out: the core knows the default. */
  restore(shown: string): void {
    this.#notices.clear();
    const { link, values } = this.readLink(shown);
    const named = new Map(new URLSearchParams(link));
    const style = values.find(([key]) => key === "style");
    named.delete("style");
    this.#take(linkText([...named, ...(style && this.#reading.namesStyle ? [style] : [])]));
  }

  /**
   * Changes some values and drops their notices; `auto` takes back a value that the word then decides. Notices about
   * other values stay until they are dismissed.
   */
  set(changes: readonly (readonly [key: string, value: string])[]): void {
    for (const [key] of changes) this.#notices.delete(key);
    this.#take(changed(this.link, changes));
  }

  /** Reads the recipe again after the page has become dark or light. */
  refresh(): void {
    this.#defaults = undefined;
    this.set([]);
  }

  dismissNotices(): void {
    this.#notices.clear();
  }

  #take(text: string): Reading {
    const reading = this.#readHere(text);
    this.#reading = reading;
    this.#values = new Map(reading.values);
    this.#asked = askedBy(reading);
    this.#idle = new Map(reading.idle);
    for (const { key, message } of reading.notices) {
      const before = this.#notices.get(key);
      this.#notices.set(key, before ? `${before}; ${message}` : message);
    }
    return reading;
  }

  /** Reads a link as it is shown on this page. */
  #readHere(text: string): Reading {
    return this.readLink(text, { dark: this.isOnDark() });
  }
}

/** Returns what a link says of every key. */
function askedBy({ values, auto, link }: Reading): ReadonlyMap<string, string> {
  const named = new URLSearchParams(link);
  const decided = new Set(auto);
  return new Map(values.map(([key, value]) => [key, decided.has(key) ? AUTO : (named.get(key) ?? value)]));
}
