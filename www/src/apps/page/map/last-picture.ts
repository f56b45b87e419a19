/**
 * Keeps the last picture over the canvas until the next map is finished: a poster or a whole map is better than a
 * land without rivers. If the next one takes long, its growth is shown instead.
 */

import { el } from "../../../browser/dom.ts";

/** The time after which somebody would rather see rivers grow than the last map. */
export const PATIENCE_MS = 2500;

export class LastPicture {
  #copy: HTMLCanvasElement | undefined;
  #patience: ReturnType<typeof setTimeout> | undefined;

  /** Takes the frame, which may contain a poster: that is the first of the last pictures. */
  constructor(private readonly frame: HTMLElement) {
    this.#wait();
  }

  /** Keeps what is on the canvas. What is kept already stays: below it may be half a map. */
  keep(canvas: HTMLCanvasElement): void {
    this.#wait();
    if (!this.#isFirst && !this.#copy) this.#lay(canvas);
  }

  /** Lets go of the last picture, now that there is a better one: it fades. */
  fade(): void {
    this.#end();
    const copy = this.#copy;
    this.#copy = undefined;
    if (!copy) return;
    copy.addEventListener("transitionend", () => copy.remove());
    copy.addEventListener("transitioncancel", () => copy.remove());
    copy.classList.add("leaving");
    // Where nothing moves, nothing ends.
    if (copy.getAnimations().length === 0) copy.remove();
  }

  /** Takes the last picture away at once: the map is moved, and would not lie where it lay. */
  drop(): void {
    this.#end();
    this.#copy?.remove();
    this.#copy = undefined;
  }

  /** True until there has been a picture that is better than a poster. */
  get #isFirst(): boolean {
    return !("shown" in this.frame.dataset);
  }

  #lay(canvas: HTMLCanvasElement): void {
    const { width, height } = canvas;
    if (width === 0 || height === 0) return;
    const context = el("canvas", { class: "last-picture", width, height }).getContext("2d");
    if (!context) return;
    context.drawImage(canvas, 0, 0);
    this.#copy = context.canvas;
    this.#copy.style.transform = canvas.style.transform;
    this.#copy.ariaHidden = "true";
    canvas.after(this.#copy);
  }

  #wait(): void {
    clearTimeout(this.#patience);
    this.#patience = setTimeout(() => this.fade(), PATIENCE_MS);
  }

  #end(): void {
    clearTimeout(this.#patience);
    this.frame.dataset["shown"] = "";
  }
}
