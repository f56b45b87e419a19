/** What embed.html says when something is wrong: in the river's place, or over the river. */

import { el } from "../../browser/dom.ts";
import { advice } from "../../engine/advice.ts";
import { PageError } from "../../engine/errors.ts";
import type { ErrorDetail } from "../widget/events.ts";

/** In the river's place: what happened, what can be done, and its name for the owner of the page. */
export function failureNote({ code, message }: ErrorDetail): HTMLElement {
  const { title, text } = advice(new PageError(code, message));
  return el(
    "div",
    { class: "note", role: "alert" },
    el("p", { class: "title" }, title),
    el("p", {}, text),
    el("p", { class: "detail" }, `${code}: ${message}`),
  );
}

/** Over the river, until it is dismissed: what in the link had to be corrected. */
export function correctionsNote(notices: readonly { readonly message: string }[]): HTMLElement {
  const close = el("button", { type: "button" }, "Dismiss");
  const note = el(
    "div",
    { class: "note corrected", role: "status" },
    el("ul", {}, ...notices.map(({ message }) => el("li", {}, message))),
    close,
  );
  close.addEventListener("click", () => note.remove());
  return note;
}
