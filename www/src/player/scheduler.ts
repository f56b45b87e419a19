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
 * first in the next frame. Rivers out of sight come after them, in what is left of the frame, but have one turn in any
 * case. Of these the last comes first, so that one is finished after the other, and those first that are met first on
 * the way back.
 */
export class SharedScheduler implements Frames {
  readonly #waiting = new Map<number, (now: number) => void>();
  readonly #unseen = new Map<number, (now: number) => void>();
  #last = 0;
  #isAsked = false;

  constructor(
    private readonly display: Frames,
    private readonly shareMs = SHARE_MS,
    readonly waitMs?: number,
  ) {}

  now(): number {
    return this.display.now();
  }

  /** True while a river waits for its turn. */
  get isAwaited(): boolean {
    return this.#waiting.size + this.#unseen.size > 0;
  }

  request(callback: (now: number) => void, isUnseen = false): number {
    (isUnseen ? this.#unseen : this.#waiting).set(++this.#last, callback);
    this.#ask();
    return this.#last;
  }

  cancel(handle: number): void {
    this.#waiting.delete(handle);
    this.#unseen.delete(handle);
  }

  #ask(): void {
    if (this.#isAsked) return;
    this.#isAsked = true;
    this.display.request((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#isAsked = false;
    const end = this.now() + this.shareMs;
    // A request that is made in this frame is for the next one.
    const [seen, unseen] = [[...this.#waiting.keys()], [...this.#unseen.keys()].reverse()];
    this.#run(this.#waiting, seen, now, end);
    this.#run(this.#unseen, unseen, now, end);
    if (this.isAwaited) this.#ask();
  }

  /** Calls one of them, and more while there is time. */
  #run(waiting: Map<number, (now: number) => void>, handles: readonly number[], now: number, end: number): void {
    for (const handle of handles) {
      const callback = waiting.get(handle);
      // It was cancelled by one before it.
      if (!callback) continue;
      waiting.delete(handle);
      callback(now);
      if (this.now() >= end) break;
    }
  }
}
