/** When a height is told: once it has come to rest, and only if it is another one. */

/** A window that is dragged changes the height every frame; the page around lays itself out anew each time it is told. */
export const REST_MS = 60;

export class Heights {
  #told: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly tell: (height: number) => void) {}

  changed(height: number): void {
    clearTimeout(this.#timer);
    if (!(height > 0 && Number.isFinite(height))) return;
    // Upward: a pixel of nothing is less of a loss than a pixel of river.
    this.#timer = setTimeout(() => this.#settle(Math.ceil(height)), REST_MS);
  }

  #settle(height: number): void {
    if (height === this.#told) return;
    this.#told = height;
    this.tell(height);
  }
}
