/** Keeps a picture of the whole map while only a part of it is on the screen, for paper. */

import type { Box, Size } from "../../../browser/canvas.ts";
import { el } from "../../../browser/dom.ts";

export class WholeMap {
  #canvas: HTMLCanvasElement | undefined;

  /** Copies the map from its picture, and puts the copy beside that. `map` is its place in the picture's `place`. */
  keep(picture: HTMLCanvasElement, map: Box, place: Size): void {
    this.forget();
    const scale = picture.width / place.width;
    const canvas = el("canvas", { class: "whole-map", "aria-hidden": "true" });
    canvas.width = Math.round(map.width * scale);
    canvas.height = Math.round(map.height * scale);
    const context = canvas.getContext("2d", { alpha: false });
    if (!context) return;
    context.drawImage(picture, -map.x * scale, -map.y * scale);
    picture.after(canvas);
    this.#canvas = canvas;
  }

  /** Forgets the map, since it is another one now. */
  forget(): void {
    this.#canvas?.remove();
    this.#canvas = undefined;
  }
}
