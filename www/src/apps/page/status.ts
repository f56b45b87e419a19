/** The page's messages: announcements, notes and failures. */

import { el } from "../../browser/dom.ts";
import { advice } from "../../engine/advice.ts";
import type { PageError } from "../../engine/errors.ts";

/** The delay of announcements. Dragging a slider finishes many rivers, and only the last one is announced. */
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

  /** Drops a waiting announcement, which is out of date. */
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

/** Makes a note with a button that undoes the reported change. */
export function undoable(message: string, name: string, undo: () => void): HTMLElement {
  const button = el("button", { type: "button", class: "quiet" }, name);
  button.addEventListener("click", undo);
  return el("span", {}, message, " ", button);
}

/** Shows a failure in the picture's place. Its link to a fresh river leaves out the recipe, which may be the cause. */
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
