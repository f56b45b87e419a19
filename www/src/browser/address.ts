/** The address bar, which always contains the link of the picture on show. */

import { withoutTrackers } from "./trackers.ts";

/** The least time between two writes. Safari refuses more than 100 in 30 s; a slider makes hundreds. */
export const WRITE_EVERY_MS = 500;

interface Place {
  search: string;
  hash: string;
}

/** The part of an address that is about the page and not the picture: it shows six variants side by side. */
const SIX = "view=six";

/** Returns the link text in an address: its fragment if that contains a “=”, as it is or encoded, or else its query. */
export function linkOf(place: Place): string {
  return without(textOf(place), SIX);
}

/** Returns link text from an address as the core takes it: as a query, so that it mends what was typed behind the address. */
export function asQuery(link: string): string {
  return link.includes("=") ? `?${link}` : link;
}

/** Returns whether an address asks for the six variants. */
export function asksForSix(place: Place): boolean {
  return textOf(place).split("&").includes(SIX);
}

/** Adds the request for six variants to a link, for the address alone. */
export function withSix(link: string): string {
  return link === "" ? SIX : `${link}&${SIX}`;
}

function textOf({ search, hash }: Place): string {
  const fragment = withoutTrackers(hash.slice(1));
  return /=|%3D/i.test(fragment) ? fragment : withoutTrackers(search.slice(1));
}

function without(text: string, part: string): string {
  return text
    .split("&")
    .filter((one) => one !== part)
    .join("&");
}

/** Returns the full address that shows `link`; `page` is the page's own address. */
export function addressOf(link: string, page: string): string {
  const address = new URL(page);
  address.search = link;
  address.hash = "";
  return address.href;
}

/** The number of writes that may come sooner within `SOONER_MS`: all writes together stay below Safari's limit. */
const MOST_SOONER = 30;
const SOONER_MS = 30_000;

/**
 * Writes links at a bounded rate: the first at once, then the latest when the time is up. A step of history is written
 * even if another follows soon.
 */
export class AddressBar {
  #lastWrite = Number.NEGATIVE_INFINITY;
  /** The times of writes that came sooner. */
  #sooner: number[] = [];
  #waiting: { link: string; isStep: boolean } | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly write: (link: string, isStep: boolean) => void) {}

  /** Takes the link on show. `isStep` makes it another step that can be undone. */
  show(link: string, isStep = false): void {
    if (isStep) this.#makeWay();
    this.#waiting = { link, isStep: isStep || (this.#waiting?.isStep ?? false) };
    const wait = this.#lastWrite + WRITE_EVERY_MS - performance.now();
    if (wait <= 0) this.flush();
    else this.#timer ??= setTimeout(() => this.flush(), wait);
  }

  /** Writes the waiting link now: before the link is copied, or when the page is left. */
  flush(): void {
    const waiting = this.#waiting;
    this.drop();
    if (waiting === undefined) return;
    this.#lastWrite = performance.now();
    this.write(waiting.link, waiting.isStep);
  }

  /** Forgets the waiting link, since the address has been replaced. */
  drop(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#waiting = undefined;
  }

  /** Writes the waiting link, which belongs to the step before. If a held key makes too many steps they become one. */
  #makeWay(): void {
    if (this.#waiting === undefined) return;
    const now = performance.now();
    this.#sooner = this.#sooner.filter((time) => now - time < SOONER_MS);
    if (this.#sooner.length >= MOST_SOONER) return;
    this.#sooner.push(now);
    this.flush();
  }
}
