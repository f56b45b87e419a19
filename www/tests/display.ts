/** Stand-ins for what a browser shows pictures by. */

import type { Frames } from "../src/player/frame-loop.ts";

/** A display whose frames come sixty a second and whose clock nothing but frames moves: work takes no time. */
export class Display implements Frames {
  /** How many frames have been. */
  count = 0;
  readonly #callbacks = new Map<number, (now: number) => void>();
  #handles = 0;

  now(): number {
    return (this.count * 1000) / 60;
  }

  request(callback: (now: number) => void): number {
    this.#callbacks.set(++this.#handles, callback);
    return this.#handles;
  }

  cancel(handle: number): void {
    this.#callbacks.delete(handle);
  }

  /** The next frame; returns whether anybody had asked for it. */
  frame(): boolean {
    const callbacks = [...this.#callbacks];
    for (const [handle, callback] of callbacks) {
      // One may take another's back.
      if (this.#callbacks.delete(handle)) callback(this.now());
    }
    this.count++;
    return callbacks.length > 0;
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
