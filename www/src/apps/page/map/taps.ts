/** Recognizes double taps: two taps of one finger on the same spot. Two fingers, a drag, or a long press are no tap. */

import type { Point } from "./camera.ts";

/** The limits of a tap in time and movement, and of the second tap after the first, in ms and CSS pixels. */
const TAP_MS = 300;
export const PAUSE_MS = 350;
const TAP_PX = 12;
const APART_PX = 40;

/** The part of a pointer event that is used here. */
export interface Touch {
  readonly pointerType: string;
  readonly isPrimary: boolean;
  readonly clientX: number;
  readonly clientY: number;
  readonly timeStamp: number;
}

interface Spot extends Point {
  at: number;
}

export class DoubleTap {
  #down: Spot | undefined;
  #first: Spot | undefined;

  down(touch: Touch): void {
    if (!isFinger(touch)) return;
    // A second finger makes it a pinch.
    this.#down = touch.isPrimary ? spotOf(touch) : undefined;
    if (!touch.isPrimary) this.#first = undefined;
  }

  /** Takes the lifting of a finger. Returns whether that ends a double tap. */
  up(touch: Touch): boolean {
    const [down, first] = [this.#down, this.#first];
    this.#down = this.#first = undefined;
    const spot = spotOf(touch);
    const isTap = isFinger(touch) && touch.isPrimary && down !== undefined && isNear(down, spot, TAP_MS, TAP_PX);
    if (!isTap) return false;
    if (first && isNear(first, spot, PAUSE_MS, APART_PX)) return true;
    this.#first = spot;
    return false;
  }

  /** Forgets a finger that the browser has taken over. */
  cancel(): void {
    this.#down = this.#first = undefined;
  }
}

function isFinger({ pointerType }: Touch): boolean {
  return pointerType === "touch";
}

function spotOf({ clientX: x, clientY: y, timeStamp: at }: Touch): Spot {
  return { x, y, at };
}

function isNear(one: Spot, other: Spot, ms: number, px: number): boolean {
  return other.at - one.at <= ms && Math.hypot(other.x - one.x, other.y - one.y) <= px;
}
