/** The recipe on show, always in the core's own spelling: the page changes values, the core reads the link once and answers. */

import type { Reading } from "./full.ts";
import { linkText } from "./link-text.ts";
import type { ReadOptions } from "./types.ts";

export class Recipe {
  #reading: Reading;
  #values: ReadonlyMap<string, string> = new Map();
  #idle: ReadonlyMap<string, string> = new Map();
  readonly #notices = new Map<string, string>();
  /** Read when they are first asked for, which the first picture need not wait for. */
  #defaults: ReadonlyMap<string, string> | undefined;
  /** True if somebody chose how it looks: the author of a link, or a person at the controls. */
  #isStyled: boolean;

  /** Takes the first link. On a dark page a recipe that nobody has given a style is shown in that for dark pages. */
  constructor(
    private readonly readLink: (text: string, options?: ReadOptions) => Reading,
    text = "",
    private readonly isOnDark: () => boolean = () => false,
  ) {
    this.#reading = this.#take(text);
    this.#isStyled = this.#reading.namesStyle;
  }

  /** The canonical link to share, with the style that was chosen, if one was, even the default. */
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

  /** The values of what is shown. */
  get values(): ReadonlyMap<string, string> {
    return this.#values;
  }

  /** The value that every key has on this page if nobody says otherwise. */
  get defaults(): ReadonlyMap<string, string> {
    this.#defaults ??= new Map(this.#readHere("").values);
    return this.#defaults;
  }

  /** Why keys do nothing, by key. */
  get idle(): ReadonlyMap<string, string> {
    return this.#idle;
  }

  /** Values that had to be clamped or left out, by the key they are about. */
  get notices(): ReadonlyMap<string, string> {
    return this.#notices;
  }

  /** Says in words what a widget does not grow of it. */
  get widgetNotices(): string[] {
    return this.readLink(this.link, { widget: true }).notices.map(({ message }) => message);
  }

  get seed(): string {
    return this.#values.get("seed") ?? "";
  }

  /** Takes a whole link, from an address or a person. */
  open(text: string): void {
    this.#notices.clear();
    this.#isStyled = this.#take(text).namesStyle;
  }

  /** Goes back to what is shown. */
  restore(shown: string): void {
    this.#notices.clear();
    this.#takeValues(new Map(this.readLink(shown).values));
  }

  /** Changes some values. A note about another one stays until it is dismissed; one about these is out of date. */
  set(changes: Iterable<readonly [key: string, value: string]>): void {
    const values = new Map(this.#values);
    for (const [key, value] of changes) {
      values.set(key, value);
      this.#isStyled ||= key === "style";
      this.#notices.delete(key);
    }
    this.#takeValues(values);
  }

  /** The page has become dark, or light. */
  refresh(): void {
    this.#defaults = undefined;
    this.set([]);
  }

  dismissNotices(): void {
    this.#notices.clear();
  }

  /** A style that nobody chose is left out: the core knows which it is. */
  #takeValues(values: Map<string, string>): void {
    if (!this.#isStyled) values.delete("style");
    this.#take(linkText(values));
  }

  #take(text: string): Reading {
    const reading = this.#readHere(text);
    this.#reading = reading;
    this.#values = new Map(reading.values);
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
