/** Stand-ins for what a browser shows pictures by. */

import type { Frames } from "../src/player/frame-loop.ts";

/** A display whose frames come sixty a second and whose clock nothing but frames moves: work takes no time. */
export class Display implements Frames {
  /** How many frames have been. */
  count = 0;
  #callback: ((now: number) => void) | undefined;

  now(): number {
    return (this.count * 1000) / 60;
  }

  request(callback: (now: number) => void): number {
    this.#callback = callback;
    return 1;
  }

  cancel(): void {
    this.#callback = undefined;
  }

  /** The next frame; returns whether anybody had asked for it. */
  frame(): boolean {
    const callback = this.#callback;
    this.#callback = undefined;
    callback?.(this.now());
    this.count++;
    return callback !== undefined;
  }
}

/** As much of ImageData as is looked at. */
export class Image {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
}
