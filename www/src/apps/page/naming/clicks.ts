/**
 * Recognizes clicks and taps on the map. A drag, a pinch, a double click, which zooms, and a double tap, which leaves
 * the map alone, are none.
 */

import { isOnMap } from "../map/gestures.ts";
import { DoubleTap, PAUSE_MS } from "../map/taps.ts";

/** The limits of a tap in time, and of a tap and a click in movement. */
const TAP_MS = 600;
const TAP_PX = { touch: 10, mouse: 4 };

export interface Click {
  x: number;
  y: number;
  isTouch: boolean;
}

export interface ClickEvents {
  click(click: Click): void;
  /** Called when a click turns out to be the first of two. */
  double(): void;
}

export class Clicks {
  #down: { x: number; y: number; at: number; id: number } | undefined;
  readonly #taps = new DoubleTap();
  /** A tap that may be the first of two. */
  #single: ReturnType<typeof setTimeout> | undefined;

  constructor(
    place: HTMLElement,
    private readonly events: ClickEvents,
  ) {
    place.addEventListener("pointerdown", (event) => this.#onDown(event));
    place.addEventListener("pointerup", (event) => this.#onUp(event));
    place.addEventListener("pointercancel", () => {
      this.#taps.cancel();
      this.#down = undefined;
    });
    place.addEventListener("dblclick", () => events.double());
  }

  #onDown(event: PointerEvent): void {
    const { clientX: x, clientY: y, timeStamp: at, pointerId: id } = event;
    clearTimeout(this.#single);
    if (isOnMap(event)) this.#taps.down(event);
    // A second finger makes it a pinch.
    const isPlain = event.isPrimary && event.button === 0 && !event.ctrlKey && !event.metaKey && !event.shiftKey;
    this.#down = isPlain && isOnMap(event) ? { x, y, at, id } : undefined;
  }

  #onUp(event: PointerEvent): void {
    const { clientX: x, clientY: y, timeStamp, pointerId, pointerType } = event;
    const isDouble = this.#taps.up(event);
    const down = this.#down;
    this.#down = undefined;
    if (!down || down.id !== pointerId || isDouble) return;
    const isTouch = pointerType === "touch";
    const isNear = Math.hypot(x - down.x, y - down.y) <= (isTouch ? TAP_PX.touch : TAP_PX.mouse);
    if (!isNear || (isTouch && timeStamp - down.at > TAP_MS)) return;
    if (isTouch) this.#single = setTimeout(() => this.events.click({ x, y, isTouch }), PAUSE_MS);
    else this.events.click({ x, y, isTouch });
  }
}
