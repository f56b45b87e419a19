/** The address bar: where the link of the picture that is shown always stands. */

import { withoutTrackers } from "./trackers.ts";

/** At most one write in this time. Safari refuses more than 100 in 30 s; a slider makes hundreds. */
export const WRITE_EVERY_MS = 500;

/** The link text in an address: its query, or its fragment if that holds a link and there is no other way to tell. */
export function linkOf(place: { search: string; hash: string }): string {
  const fragment = withoutTrackers(place.hash.slice(1));
  return fragment.includes("=") ? fragment : withoutTrackers(place.search.slice(1));
}

/** The whole address that shows `link`, from the page's own. */
export function addressOf(link: string, page: string): string {
  const address = new URL(page);
  address.search = link;
  address.hash = "";
  return address.href;
}

/** Writes links at a bounded rate: the first at once, then the latest when the time is up. */
export class AddressBar {
  #lastWrite = Number.NEGATIVE_INFINITY;
  #waiting: { link: string; isStep: boolean } | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly write: (link: string, isStep: boolean) => void) {}

  /** A link is on show; with it, perhaps, another step of what can be undone. */
  show(link: string, isStep = false): void {
    this.#waiting = { link, isStep: isStep || (this.#waiting?.isStep ?? false) };
    const wait = this.#lastWrite + WRITE_EVERY_MS - performance.now();
    if (wait <= 0) this.flush();
    else this.#timer ??= setTimeout(() => this.flush(), wait);
  }

  /** Writes what waits, now: before the link is copied, or when the page is left. */
  flush(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (this.#waiting === undefined) return;
    const { link, isStep } = this.#waiting;
    this.#waiting = undefined;
    this.#lastWrite = performance.now();
    this.write(link, isStep);
  }
}
