/** What is to be seen of a widget: what its author put there until there is a river, the canvas, the button, and announcements. */

import { type CanvasSize, type Fit, fitOf, type Size } from "../../browser/canvas.ts";
import { el, setText } from "../../browser/dom.ts";
import { sharedSheet } from "./sheet.ts";

/** What the button does next. */
export type Does = "pause" | "play" | "replay";

export class View {
  readonly #own = new CSSStyleSheet();
  readonly #note = el("p", { part: "note", hidden: true });
  readonly #slot = el("slot", {}, this.#note);
  /** What the canvas covers. */
  readonly #frame = el("div");
  readonly #button = el("button", { type: "button", part: "button", hidden: true });
  readonly #status = el("span", { part: "status", role: "status" });
  #canvas: HTMLCanvasElement | undefined;
  /** Not seen before there is something on it. */
  #next: HTMLCanvasElement | undefined;
  #label = "";
  /** Its own rules: the element's shape, and how the canvas is laid out. */
  #shape = "";
  #layout = "";

  constructor(root: ShadowRoot, pressed: () => void) {
    root.adoptedStyleSheets = [sharedSheet(), this.#own];
    root.append(this.#slot, this.#frame, this.#button, this.#status);
    this.#button.addEventListener("click", pressed);
  }

  /**
   * Gives the element its shape, which its author's own style sheet may overrule. After a failure it is as high as what is left,
   * also where its author reserved the river's room: nothing is to come into it.
   */
  shape(aspect: number, hasFailed: boolean): void {
    this.#shape = `:host { ${hasFailed ? "aspect-ratio: auto !important" : `aspect-ratio: ${aspect}`} }`;
    this.#applyRules();
  }

  /** Lays the canvas over the whole frame, whatever its pixels: until it is painted again. */
  stretch(): void {
    this.#layout = "";
    this.#applyRules();
  }

  /** Lays the canvas out so that it shows pixel for pixel, and says how many it is to have. */
  fit(): CanvasSize {
    const { pixels, css } = this.#measure();
    this.#layout = `canvas { width: ${css.width}px; height: ${css.height}px }`;
    this.#applyRules();
    return { ...pixels, ratio: css.width > 0 ? pixels.width / css.width : 1 };
  }

  /** A canvas for another river, unseen as yet. */
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

  /** How many pixels the picture has here; none while the element is not laid out. Of another shape, the map covers the box. */
  get size(): Size {
    return this.#measure().pixels;
  }

  #applyRules(): void {
    this.#own.replaceSync(`${this.#shape} ${this.#layout}`);
  }

  #measure(): Fit {
    return fitOf(this.#frame, window.devicePixelRatio);
  }

  /** Names the picture; an empty name makes it an ornament. */
  name(label: string): void {
    this.#label = label;
    for (const canvas of [this.#canvas, this.#next]) {
      canvas?.setAttribute("role", "img");
      canvas?.setAttribute("aria-label", label);
      canvas?.setAttribute("aria-hidden", String(label === ""));
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

  /** Announces something politely, once. */
  say(text: string): void {
    setText(this.#status, text);
  }
}
