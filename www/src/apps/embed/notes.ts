/** The notes of embed.html when something is wrong: in place of the river, or over it. */

import { el } from "../../browser/dom.ts";
import { advice } from "../../engine/advice.ts";
import { PageError } from "../../engine/errors.ts";
import type { ErrorDetail } from "../widget/events.ts";

/** Makes the note in place of the river: the failure, advice, and the error's code for the owner of the page. */
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

/** Makes the note over the river with the corrections of the link, which can be dismissed. */
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
