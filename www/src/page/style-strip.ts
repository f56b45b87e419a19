/** The strip of styles: a small picture of the map on show in each of them. */

import { el } from "../browser/dom.ts";
import type { Parameter } from "../engine/full.ts";
import type { Thumbnail } from "../player/thumbnails.ts";

/** The small pictures, in CSS pixels. */
const SIZE = { width: 112, height: 64 };

/** In the order in which they are offered; what is not here follows. */
const FIRST = ["atlas", "night", "survey", "parchment", "basins", "past-courses", "ink-wash", "orbit", "blueprint"];

export class StyleStrip {
  readonly #buttons = new Map<string, { button: HTMLButtonElement; canvas: HTMLCanvasElement }>();
  readonly #ratio = Math.min(2, Math.max(1, Math.ceil(window.devicePixelRatio)));

  constructor(place: HTMLElement, style: Parameter | undefined, choose: (style: string) => void) {
    const choices = style?.choices ?? [];
    const rank = (value: string): number => (FIRST.indexOf(value) + FIRST.length + 1) % (FIRST.length + 1);
    for (const { value } of [...choices].sort((a, b) => rank(a.value) - rank(b.value))) {
      const { width, height } = this.size;
      const canvas = el("canvas", { width, height, "aria-hidden": "true" });
      const button = el(
        "button",
        { type: "button", class: "style", "aria-pressed": "false" },
        canvas,
        el("span", {}, nameOf(value)),
      );
      button.addEventListener("click", () => choose(value));
      // Browsers leave what is seen in part where it is.
      button.addEventListener("focus", () => button.scrollIntoView({ block: "nearest", inline: "nearest" }));
      this.#buttons.set(value, { button, canvas });
      place.append(button);
    }
  }

  get styles(): string[] {
    return [...this.#buttons.keys()];
  }

  /** Of a picture, in its own pixels. */
  get size(): { width: number; height: number } {
    return { width: SIZE.width * this.#ratio, height: SIZE.height * this.#ratio };
  }

  show(style: string): void {
    for (const [value, { button }] of this.#buttons) button.setAttribute("aria-pressed", String(value === style));
  }

  draw({ style, width, height, pixels }: Thumbnail): void {
    const image = new ImageData(pixels, width, height);
    this.#buttons.get(style)?.canvas.getContext("2d")?.putImageData(image, 0, 0);
  }
}

/** A style's name: its word, as people write it. */
function nameOf(value: string): string {
  const words = value.replaceAll("-", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
