/** When a height is posted: once it has come to rest, and only if it has changed. */

/** A window that is dragged changes the height every frame; the page around would lay itself out again for each. */
export const REST_MS = 60;

export class Heights {
  #posted: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly post: (height: number) => void) {}

  changed(height: number): void {
    clearTimeout(this.#timer);
    if (!(height > 0 && Number.isFinite(height))) return;
    // Upward: a pixel of nothing is less of a loss than a pixel of river.
    this.#timer = setTimeout(() => this.#settle(Math.ceil(height)), REST_MS);
  }

  #settle(height: number): void {
    if (height === this.#posted) return;
    this.#posted = height;
    this.post(height);
  }
}
