/** What is to be seen of a widget: what its author put there until there is a river, the canvas, the button, and what is said. */

import { type Box, backingSize, type Size } from "../canvas.ts";
import { el, setText } from "../dom.ts";
import { sharedSheet } from "./sheet.ts";

/** What the button does next. */
export type Does = "pause" | "play" | "replay";

export class View {
  readonly #own = new CSSStyleSheet();
  readonly #note = el("p", { part: "note", hidden: true });
  readonly #slot = el("slot", {}, this.#note);
  readonly #button = el("button", { type: "button", part: "button", hidden: true });
  readonly #status = el("span", { part: "status", role: "status" });
  #canvas: HTMLCanvasElement | undefined;
  /** Not seen before there is something on it. */
  #next: HTMLCanvasElement | undefined;
  #label: string | undefined;

  constructor(
    private readonly root: ShadowRoot,
    pressed: () => void,
  ) {
    root.adoptedStyleSheets = [sharedSheet(), this.#own];
    root.append(this.#slot, this.#button, this.#status);
    this.#button.addEventListener("click", pressed);
  }

  /** Gives the element its shape, which its author's own style sheet may overrule. What is left after a failure may be taller. */
  shape(aspect: number, hasFailed: boolean): void {
    this.#own.replaceSync(`:host { aspect-ratio: ${aspect}; ${hasFailed ? "min-block-size: auto" : ""} }`);
  }

  /** A canvas for another river, unseen as yet. */
  prepare(): HTMLCanvasElement {
    this.#next?.remove();
    this.#next = el("canvas", { part: "canvas", class: "waits" });
    this.#slot.after(this.#next);
    this.name(this.#label);
    return this.#next;
  }

  /** Shows the canvas that was prepared. */
  reveal(): void {
    if (!this.#next) return;
    this.#canvas?.remove();
    this.#canvas = this.#next;
    this.#next = undefined;
    this.#canvas.classList.remove("waits");
    // A worker's word can be here before its picture: what was there stays under it for as long.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        this.#slot.hidden = this.#canvas !== undefined;
      }),
    );
  }

  /** Takes the canvas away: what the author put in its place is there again. */
  clear(): void {
    this.#canvas?.remove();
    this.#next?.remove();
    this.#canvas = this.#next = undefined;
    this.#slot.hidden = false;
    this.note("");
    this.button(undefined, "", {});
  }

  /** Says why there is nothing, where the author put nothing in the picture's place. */
  note(text: string): void {
    setText(this.#note, text);
    this.#note.hidden = text === "";
  }

  /** How many pixels a river of this shape has here; none while the element is not laid out. */
  sizeFor(aspect: number): Size {
    const canvas = this.#next ?? this.#canvas;
    const box = (canvas ?? this.root.host).getBoundingClientRect();
    const place = fitted(box, aspect);
    canvas?.classList.toggle("loose", place !== box);
    return backingSize(place, window.devicePixelRatio);
  }

  /** Names the picture; an empty name makes it an ornament. */
  name(label: string | undefined): void {
    this.#label = label;
    for (const canvas of [this.#canvas, this.#next]) {
      if (!canvas || label === undefined) continue;
      const [attributes, others] =
        label === ""
          ? [{ "aria-hidden": "true" }, ["role", "aria-label"]]
          : [{ role: "img", "aria-label": label }, ["aria-hidden"]];
      for (const [name, value] of Object.entries(attributes)) canvas.setAttribute(name, value);
      for (const name of others) canvas.removeAttribute(name);
    }
  }

  /** Shows the button, or none. */
  button(does: Does | undefined, label: string, { isQuiet = false, isDark = false }): void {
    this.#button.hidden = does === undefined;
    if (does === undefined) return;
    this.#button.dataset["does"] = does;
    this.#button.setAttribute("aria-label", label);
    this.#button.title = label;
    this.#button.classList.toggle("quiet", isQuiet);
    this.#button.classList.toggle("dark", isDark);
  }

  /** Says something politely; what has been said is not said again. */
  say(text: string): void {
    setText(this.#status, text);
  }
}

/** The largest place of a shape in the middle of a box; the box itself if that is its shape but for a part of a pixel. */
export function fitted(box: Box, aspect: number): Box {
  const width = Math.min(box.width, box.height * aspect);
  const height = Math.min(box.height, box.width / aspect);
  if (box.width - width < 1 && box.height - height < 1) return box;
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}
