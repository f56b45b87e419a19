/** The recipe on show, always in the core's own spelling: what the page changes, the core reads and answers. */

import { linkText } from "./link-text.ts";
import { DARK_STYLE, namesStyle } from "./scheme.ts";
import type { Reading } from "./types.ts";

export class Recipe {
  #link = "";
  #values = new Map<string, string>();
  #idle = new Map<string, string>();
  #notices = new Map<string, string>();
  /** Whether somebody has said how it looks: the author of a link, or whoever chose a style on a dark page. */
  #isStyled = false;

  /** On a dark page a recipe that nobody has given a style is shown in that for dark pages. */
  constructor(
    private readonly read: (text: string) => Reading,
    private readonly isOnDark: () => boolean = () => false,
  ) {}

  /** Its canonical link; where a page's own style would stand in for a style that was chosen, with that. */
  get link(): string {
    const isTold = this.isOnDark() && this.#isStyled && !namesStyle(this.#link);
    return isTold ? `${this.#link}&${linkText([["style", this.#values.get("style") ?? ""]])}` : this.#link;
  }

  /** The link of what is shown. */
  get shown(): string {
    return this.#isDarkened ? this.read(linkText(this.values)).link : this.#link;
  }

  /** The values of what is shown. */
  get values(): ReadonlyMap<string, string> {
    return this.#isDarkened ? new Map(this.#values).set("style", DARK_STYLE) : this.#values;
  }

  get #isDarkened(): boolean {
    return this.isOnDark() && !this.#isStyled;
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
    this.#isStyled = namesStyle(text);
    this.#take(this.read(text));
  }

  /** Goes back to what is shown. */
  restore(shown: string): void {
    const isStyled = this.#isStyled;
    const link = new URLSearchParams(shown);
    if (this.#isDarkened) link.delete("style");
    this.open(linkText(link));
    this.#isStyled = isStyled;
  }

  /** Changes some values. A note about another one stays until it is dismissed; one about these is out of date. */
  set(changes: Iterable<readonly [key: string, value: string]>): void {
    const values = new Map(this.#values);
    for (const [key, value] of changes) {
      values.set(key, value);
      this.#isStyled ||= key === "style";
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
