/** How the page says things: the announcement, notes and failures. */

import { el } from "../../browser/dom.ts";
import { advice } from "../../engine/advice.ts";
import type { PageError } from "../../engine/errors.ts";

/** Dragging a slider finishes many rivers; only the one that is left standing is announced. */
const ANNOUNCE_AFTER_MS = 1000;

export class Announcer {
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly region: HTMLElement) {}

  say(text: string): void {
    this.hush();
    this.#timer = setTimeout(() => {
      this.region.textContent = text;
    }, ANNOUNCE_AFTER_MS);
  }

  /** Drops what was about to be announced: it is out of date. */
  hush(): void {
    clearTimeout(this.#timer);
  }
}

/** Shows notes in a box, until they are dismissed. */
export function showNotices(box: HTMLElement, notices: readonly (string | Node)[], dismiss: () => void): void {
  box.hidden = notices.length === 0;
  const list = el("ul", {}, ...notices.map((notice) => el("li", {}, notice)));
  const close = el("button", { type: "button", class: "dismiss" }, "Dismiss");
  close.addEventListener("click", dismiss);
  box.replaceChildren(...(notices.length > 0 ? [list, close] : []));
}

/** A note with the way back from what it reports. */
export function undoable(message: string, name: string, undo: () => void): HTMLElement {
  const button = el("button", { type: "button", class: "quiet" }, name);
  button.addEventListener("click", undo);
  return el("span", {}, message, " ", button);
}

/** Shows a failure in the picture's place. The way out never carries the link along: it may be the cause. */
export function showFailure(box: HTMLElement, error: PageError): void {
  const { title, text, reload } = advice(error);
  const again = el("button", { type: "button" }, "Load again");
  again.addEventListener("click", () => location.reload());
  const fresh = el("a", { href: location.pathname }, "Start from a fresh river");
  const detail = el("p", { class: "detail" }, `${error.code}: ${error.message}`);
  box.replaceChildren(
    el("h2", {}, title),
    el("p", {}, text),
    el("p", { class: "actions" }, ...(reload ? [again] : []), fresh),
    detail,
  );
  box.hidden = false;
}
