/**
 * Keeps the last picture over the canvas until the next map is finished, with its names: a poster or a whole map is better
 * than a land without rivers, however long the next one takes. Growth is seen by whoever asks for it.
 */

import type { Framing } from "../../../browser/canvas.ts";
import { el } from "../../../browser/dom.ts";
import { transformBetween } from "./camera.ts";

/** The place of a map in the picture's place. */
export interface Seen {
  /** The part of the map that is seen there, and the part that is seen if all of the map is. */
  framing: Framing;
  whole: Framing;
  /** The width of the place. */
  width: number;
}

/** A copy of the canvas, with what was seen there and how it was moved. */
interface Kept {
  copy: HTMLCanvasElement;
  framing: Framing;
  transform: string;
}

export class LastPicture {
  #kept: Kept | undefined;
  readonly #poster: HTMLElement | null;

  /** Takes the frame, which may contain a poster: that is the first of the last pictures. */
  constructor(private readonly frame: HTMLElement) {
    this.#poster = frame.querySelector<HTMLElement>(".poster");
  }

  /** Keeps what is on the canvas. What is kept already stays: below it may be half a map. */
  keep(canvas: HTMLCanvasElement, { framing }: Seen): void {
    if (!this.#isFirst && !this.#kept) this.#lay(canvas, framing);
  }

  /** Moves along with the map. A poster is where all of the map is seen. */
  follow({ framing, whole, width }: Seen): void {
    if (this.#kept) {
      const { copy, framing: before, transform } = this.#kept;
      copy.style.transform = `${transformBetween(before, framing, width)} ${transform}`;
    } else if (this.#isFirst && this.#poster) {
      this.#poster.style.transform = transformBetween(whole, framing, width);
    }
  }

  /** Lets go of the last picture, now that there is a better one: it fades. */
  fade(): void {
    const copy = this.#leave();
    if (!copy) return;
    copy.addEventListener("transitionend", () => copy.remove());
    copy.addEventListener("transitioncancel", () => copy.remove());
    copy.classList.add("leaving");
    // Where nothing moves, nothing ends.
    if (copy.getAnimations().length === 0) copy.remove();
  }

  /** Takes the last picture away at once, since somebody wants to see the next as far as it is. */
  drop(): void {
    this.#leave()?.remove();
  }

  /** True until there has been a picture that is better than a poster. */
  get #isFirst(): boolean {
    return !("shown" in this.frame.dataset);
  }

  #lay(canvas: HTMLCanvasElement, framing: Framing): void {
    const { width, height } = canvas;
    if (width === 0 || height === 0) return;
    const context = el("canvas", { class: "last-picture", width, height }).getContext("2d");
    if (!context) return;
    context.drawImage(canvas, 0, 0);
    const copy = context.canvas;
    const { transform } = canvas.style;
    copy.style.transform = transform;
    copy.ariaHidden = "true";
    canvas.after(copy);
    this.#kept = { copy, framing, transform };
  }

  /** Keeps no picture from now on, and returns the one that was kept. */
  #leave(): HTMLCanvasElement | undefined {
    this.frame.dataset["shown"] = "";
    const copy = this.#kept?.copy;
    this.#kept = undefined;
    return copy;
  }
}
