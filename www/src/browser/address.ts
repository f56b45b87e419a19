/** The address bar: where the link of the picture that is shown always stands. */

import { withoutTrackers } from "./trackers.ts";

/** At most one write in this time. Safari refuses more than 100 in 30 s; a slider makes hundreds. */
export const WRITE_EVERY_MS = 500;

interface Place {
  search: string;
  hash: string;
}

/** What an address says of the page, and not of the picture: all six variants are shown side by side. */
const SIX = "view=six";

/** The link text in an address: its query, or its fragment if that holds a link and there is no other way to tell. */
export function linkOf(place: Place): string {
  return without(textOf(place), SIX);
}

/** Whether an address asks for the six variants. */
export function asksForSix(place: Place): boolean {
  return textOf(place).split("&").includes(SIX);
}

/** A link's text with the wish for the six variants, for the address alone. */
export function withSix(link: string): string {
  return link === "" ? SIX : `${link}&${SIX}`;
}

function textOf({ search, hash }: Place): string {
  const fragment = withoutTrackers(hash.slice(1));
  return fragment.includes("=") ? fragment : withoutTrackers(search.slice(1));
}

function without(text: string, part: string): string {
  return text
    .split("&")
    .filter((one) => one !== part)
    .join("&");
}

/** The whole address that shows `link`, from the page's own. */
export function addressOf(link: string, page: string): string {
  const address = new URL(page);
  address.search = link;
  address.hash = "";
  return address.href;
}

/** How many writes may come sooner, in how long: with the others they stay below what Safari takes. */
const MOST_SOONER = 30;
const SOONER_MS = 30_000;

/** Writes links at a bounded rate: the first at once, then the latest when the time is up. A step is not lost for one that follows soon. */
export class AddressBar {
  #lastWrite = Number.NEGATIVE_INFINITY;
  /** When what waited was written before its time. */
  #sooner: number[] = [];
  #waiting: { link: string; isStep: boolean } | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly write: (link: string, isStep: boolean) => void) {}

  /** A link is on show; with it, perhaps, another step of what can be undone. */
  show(link: string, isStep = false): void {
    if (isStep) this.#makeWay();
    this.#waiting = { link, isStep: isStep || (this.#waiting?.isStep ?? false) };
    const wait = this.#lastWrite + WRITE_EVERY_MS - performance.now();
    if (wait <= 0) this.flush();
    else this.#timer ??= setTimeout(() => this.flush(), wait);
  }

  /** Writes what waits, now: before the link is copied, or when the page is left. */
  flush(): void {
    const waiting = this.#waiting;
    this.drop();
    if (waiting === undefined) return;
    this.#lastWrite = performance.now();
    this.write(waiting.link, waiting.isStep);
  }

  /** Writes nothing of what waits: the address is another's by now. */
  drop(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#waiting = undefined;
  }

  /** What waits belongs to the step before. With a key that is held there would be too many: then they are one. */
  #makeWay(): void {
    if (this.#waiting === undefined) return;
    const now = performance.now();
    this.#sooner = this.#sooner.filter((time) => now - time < SOONER_MS);
    if (this.#sooner.length >= MOST_SOONER) return;
    this.#sooner.push(now);
    this.flush();
  }
}
