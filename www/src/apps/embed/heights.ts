/** Posts heights: each once it has come to rest, and only if it has changed. */

/**
 * The time without a change after which a height is posted. While a window is dragged the height changes every frame,
 * and the page around would be laid out again for each.
 */
export const REST_MS = 60;

export class Heights {
  #posted: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly post: (height: number) => void) {}

  changed(height: number): void {
    clearTimeout(this.#timer);
    if (!(height > 0 && Number.isFinite(height))) return;
    // Rounded up: an empty pixel is better than losing a pixel of river.
    this.#timer = setTimeout(() => this.#settle(Math.ceil(height)), REST_MS);
  }

  #settle(height: number): void {
    if (height === this.#posted) return;
    this.#posted = height;
    this.post(height);
  }
}
