/**
 * The visible parts of a widget: the author's content until there is a river, the canvas, the button, and
 * announcements.
 */

import { type CanvasSize, type Fit, fitOf, type Size } from "../../browser/canvas.ts";
import { el, setText } from "../../browser/dom.ts";
import { sharedSheet } from "./sheet.ts";

/** The next action of the button. */
export type Does = "pause" | "play" | "replay";

/** Content that is seen as a picture. */
const PICTURES = "img, svg, canvas, video";

export class View {
  readonly #own = new CSSStyleSheet();
  readonly #note = el("p", { part: "note", hidden: true });
  readonly #slot = el("slot", {}, this.#note);
  /** The element that the canvas covers. */
  readonly #frame = el("div");
  readonly #button = el("button", { type: "button", part: "button", hidden: true });
  readonly #status = el("span", { part: "status", role: "status" });
  #canvas: HTMLCanvasElement | undefined;
  /** A new canvas, hidden until it has a picture. */
  #next: HTMLCanvasElement | undefined;
  #label = "";
  /** The style rules of this element: its shape, and the layout of the canvas. */
  #shape = "";
  #layout = "";

  constructor(root: ShadowRoot, pressed: () => void) {
    root.adoptedStyleSheets = [sharedSheet(), this.#own];
    root.append(this.#slot, this.#frame, this.#button, this.#status);
    this.#button.addEventListener("click", pressed);
  }

  /**
   * Gives the element its shape, which the author's style sheet may override. After a failure it is only as high as its
   * remaining content, even if the author reserved space for the river, since none will come.
   */
  shape(aspect: number, hasFailed: boolean): void {
    this.#shape = `:host { ${hasFailed ? "aspect-ratio: auto !important" : `aspect-ratio: ${aspect}`} }`;
    this.#applyRules();
  }

  /** Stretches the canvas over the whole frame, until it is painted again. */
  stretch(): void {
    this.#layout = "";
    this.#applyRules();
  }

  /** Lays the canvas out so that its pixels are the screen's, and returns the size that it should have. */
  fit(): CanvasSize {
    const { pixels, css } = this.#measure();
    this.#layout = `canvas { width: ${css.width}px; height: ${css.height}px }`;
    this.#applyRules();
    return { ...pixels, ratio: css.width > 0 ? pixels.width / css.width : 1 };
  }

  /** Returns a new canvas for another river, which is hidden until `reveal`. */
  prepare(): HTMLCanvasElement {
    this.#next?.remove();
    this.#next = el("canvas", { part: "canvas", class: "waits" });
    this.#frame.append(this.#next);
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
    // A worker's report may arrive before its picture, so the old content stays under the canvas for two frames.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        this.#slot.hidden = this.#canvas !== undefined;
      }),
    );
  }

  /** Removes the canvas, so that the author's content is shown again. */
  clear(): void {
    this.#canvas?.remove();
    this.#next?.remove();
    this.#canvas = this.#next = undefined;
    this.#slot.hidden = false;
    this.note("");
    this.button(undefined, "", {});
  }

  /** Shows a text in place of the picture, if the author has provided no content. */
  note(text: string): void {
    setText(this.#note, text);
    this.#note.hidden = text === "";
  }

  /** The author's content in place of the river: whether a picture is part of it. */
  get poster(): "picture" | "words" | undefined {
    const content = this.#slot.assignedElements();
    const hasPicture = content.some((one) => one.matches(PICTURES) || one.querySelector(PICTURES));
    return hasPicture ? "picture" : content.length > 0 ? "words" : undefined;
  }

  /** The size of the picture in pixels; 0 while the element is not laid out. The map covers a box of another shape. */
  get size(): Size {
    return this.#measure().pixels;
  }

  #applyRules(): void {
    this.#own.replaceSync(`${this.#shape} ${this.#layout}`);
  }

  #measure(): Fit {
    return fitOf(this.#frame, window.devicePixelRatio);
  }

  /** Sets the picture's text alternative. An empty one makes it decorative. */
  name(label: string): void {
    this.#label = label;
    for (const canvas of [this.#canvas, this.#next]) {
      canvas?.setAttribute("role", "img");
      canvas?.setAttribute("aria-label", label);
      canvas?.setAttribute("aria-hidden", String(label === ""));
    }
  }

  /** Shows the button, or hides it if there is nothing to do. */
  button(does: Does | undefined, label: string, { isQuiet = false, isDark = false }): void {
    this.#button.hidden = does === undefined;
    if (does === undefined) return;
    this.#button.dataset["does"] = does;
    this.#button.setAttribute("aria-label", label);
    this.#button.title = label;
    this.#button.classList.toggle("quiet", isQuiet);
    this.#button.classList.toggle("dark", isDark);
  }

  /** Announces something politely, once. */
  say(text: string): void {
    setText(this.#status, text);
  }
}
