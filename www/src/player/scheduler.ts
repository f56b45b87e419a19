/** Schedulers of painting: the display's frames, and a scheduler that shares them among rivers. */

import type { Frames } from "./frame-loop.ts";

/** The display's frames. Workers of some browsers have none: there a timer stands in. */
export const displayFrames: Frames = {
  now: () => performance.now(),
  request: (callback) =>
    "requestAnimationFrame" in globalThis
      ? requestAnimationFrame(callback)
      : Number(setTimeout(() => callback(performance.now()), 16)),
  cancel: (handle) => {
    if ("cancelAnimationFrame" in globalThis) cancelAnimationFrame(handle);
    else clearTimeout(handle);
  },
};

/** The time of a frame, in ms, that all rivers of a thread share. A river that comes later waits for the next frame. */
export const SHARE_MS = 8;

/**
 * Shares the display's frames among many rivers. They take turns in the order of asking; those that were skipped go
 * first in the next frame.
 */
export class SharedScheduler implements Frames {
  readonly #waiting = new Map<number, (now: number) => void>();
  #last = 0;
  #isAsked = false;

  constructor(
    private readonly display: Frames,
    private readonly shareMs = SHARE_MS,
  ) {}

  now(): number {
    return this.display.now();
  }

  /** True while a river waits for its turn. */
  get isAwaited(): boolean {
    return this.#waiting.size > 0;
  }

  request(callback: (now: number) => void): number {
    this.#waiting.set(++this.#last, callback);
    this.#ask();
    return this.#last;
  }

  cancel(handle: number): void {
    this.#waiting.delete(handle);
  }

  #ask(): void {
    if (this.#isAsked) return;
    this.#isAsked = true;
    this.display.request((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#isAsked = false;
    const end = this.now() + this.shareMs;
    const last = this.#last;
    for (const [handle, callback] of this.#waiting) {
      // A request that was made in this frame is for the next one.
      if (handle > last) break;
      this.#waiting.delete(handle);
      callback(now);
      if (this.now() >= end) break;
    }
    if (this.#waiting.size > 0) this.#ask();
  }
}
