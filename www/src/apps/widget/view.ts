/**
 * The visible parts of a widget: the author's content until there is a river, the canvas, the button, the link to the
 * maker, the caption, and announcements.
 */

import { type CanvasSize, type Fit, fitOf, type Size } from "../../browser/canvas.ts";
import { el, setText, svg } from "../../browser/dom.ts";
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
  readonly #frame = el("div", { class: "frame" });
  readonly #button = el("button", { type: "button", part: "button", hidden: true });
  /** The link to the maker, in the element only while it has an address. */
  readonly #maker = el("a", { part: "maker" });
  readonly #status = el("span", { part: "status", role: "status" });
  /** The map without its caption. */
  readonly #map = el("div", { class: "map" }, this.#slot, this.#frame, this.#button);
  readonly #caption = el("slot", { name: "caption", part: "caption" });
  readonly #box = el("div", {}, this.#map, this.#caption);
  #canvas: HTMLCanvasElement | undefined;
  /** A new canvas, hidden until it has a picture. */
  #next: HTMLCanvasElement | undefined;
  #label = "";
  /** The aspect ratio of the map as a style, and the style rule that lays out the canvas. */
  #aspect = "auto";
  #hasFailed = false;
  #layout = "";

  /** `pressed` is called for the button, `recoloured` when the page's colour scheme has changed. */
  constructor(root: ShadowRoot, pressed: () => void, recoloured: () => void) {
    root.adoptedStyleSheets = [sharedSheet(), this.#own];
    root.append(svg("svg", { class: "strut", "aria-hidden": "true" }), this.#box, this.#status);
    this.#button.addEventListener("click", pressed);
    this.#caption.addEventListener("slotchange", () => this.#applyRules());
    // There is no event for it, but the system's colours change, and this one has a transition.
    this.#status.addEventListener("transitionrun", recoloured);
  }

  /**
   * Gives the element its shape, which the author's style sheet may override. After a failure it is only as high as its
   * remaining content, even if the author reserved space for the river, since none will come.
   */
  shape(aspect: number, hasFailed: boolean): void {
    this.#aspect = hasFailed ? "auto" : String(aspect);
    this.#hasFailed = hasFailed;
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
    this.maker("", "");
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

  /** True if the element is laid out in a box that leaves it no width. */
  get isSqueezed(): boolean {
    return this.#frame.getClientRects().length > 0 && this.size.width === 0;
  }

  /** Gives the shape to the element, or, if there is a caption below, to the map alone. */
  #applyRules(): void {
    const isCaptioned = this.#caption.assignedElements().length > 0;
    this.#box.classList.toggle("captioned", isCaptioned);
    const shape = `aspect-ratio: ${this.#aspect}${this.#hasFailed ? " !important" : ""}`;
    const place = isCaptioned && !this.#hasFailed ? ":host { background: none; border-radius: 0 } .map" : ":host";
    this.#own.replaceSync(`${place} { ${shape} } ${this.#layout}`);
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

  /** Shows the link to the map's maker, unless there is no address. */
  maker(address: string, text: string): void {
    this.#maker.href = address;
    setText(this.#maker, text);
    if (!address) this.#maker.remove();
    else if (!this.#maker.isConnected) this.#map.append(this.#maker);
  }

  /** Shows the button, or hides it if there is nothing to do. */
  button(does: Does | undefined, label: string, { isQuiet = false, isDark = false }): void {
    this.#box.classList.toggle("dark", isDark);
    this.#button.hidden = does === undefined;
    if (does === undefined) return;
    this.#button.dataset["does"] = does;
    this.#button.setAttribute("aria-label", label);
    this.#button.title = label;
    this.#button.classList.toggle("quiet", isQuiet);
  }

  /** Announces something politely, once. */
  say(text: string): void {
    setText(this.#status, text);
  }
}
