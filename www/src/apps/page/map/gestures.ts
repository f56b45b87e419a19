/** Moves and zooms the map by mouse, wheel, fingers and keys. */

import type { Point } from "./camera.ts";

export interface GestureEvents {
  /** Moves the map, in CSS pixels. */
  move(dx: number, dy: number): void;
  /** Zooms about a point of the page, or about the middle without one. */
  zoom(factor: number, about?: Point): void;
  all(): void;
}

/** The step of an arrow key, in CSS pixels, and the factor of a zoom key. */
const KEY_STEP = 60;
export const KEY_ZOOM = 1.5;
/** The exponent of zoom per pixel of the wheel; below, of a pinch on a touch pad, which reports much smaller steps. */
const WHEEL_ZOOM = 0.0015;
const PAD_ZOOM = 0.01;
const LINE_PX = 16;

const ARROWS: Record<string, [dx: number, dy: number]> = {
  ArrowLeft: [KEY_STEP, 0],
  ArrowRight: [-KEY_STEP, 0],
  ArrowUp: [0, KEY_STEP],
  ArrowDown: [0, -KEY_STEP],
};

export class Gestures {
  /** The places of the fingers or the mouse. */
  readonly #pointers = new Map<number, Point>();
  /** The type of the last pointer: a mouse, a finger or a pen. */
  #kind = "";

  constructor(
    private readonly place: HTMLElement,
    private readonly events: GestureEvents,
  ) {
    place.addEventListener("pointerdown", (event) => this.#down(event));
    place.addEventListener("pointermove", (event) => this.#moves(event));
    for (const end of ["pointerup", "pointercancel"] as const)
      place.addEventListener(end, ({ pointerId }) => this.#pointers.delete(pointerId));
    place.addEventListener("wheel", (event) => this.#turn(event), { passive: false });
    place.addEventListener("dblclick", (event) => {
      // A double tap is for the whole screen: fingers zoom by pinching.
      if (isOnMap(event) && this.#kind !== "touch") events.zoom(2, pointOf(event));
    });
    place.addEventListener("keydown", (event) => this.#onKey(event));
  }

  #down(event: PointerEvent): void {
    this.#kind = event.pointerType;
    if (!isOnMap(event) || event.button !== 0) return;
    this.place.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, pointOf(event));
  }

  #moves(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    if (!before) return;
    const now = pointOf(event);
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.#pointers.set(event.pointerId, now);
    if (!other) {
      this.events.move(now.x - before.x, now.y - before.y);
      return;
    }
    // Each of two fingers moves the map by half its way.
    this.events.move((now.x - before.x) / 2, (now.y - before.y) / 2);
    const spread = distance(before, other);
    if (spread > 0) this.events.zoom(distance(now, other) / spread, between(now, other));
  }

  #turn(event: WheelEvent): void {
    if (!isOnMap(event)) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : LINE_PX);
    this.events.zoom(Math.exp(-pixels * (event.ctrlKey ? PAD_ZOOM : WHEEL_ZOOM)), pointOf(event));
  }

  #onKey(event: KeyboardEvent): void {
    if (event.target !== this.place || event.altKey || event.ctrlKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) this.events.move(...arrow);
    else if (event.key === "+" || event.key === "=") this.events.zoom(KEY_ZOOM);
    else if (event.key === "-") this.events.zoom(1 / KEY_ZOOM);
    else if (event.key === "0") this.events.all();
    else return;
    event.preventDefault();
  }
}

/**
 * Returns whether a gesture is on the map itself. Things over the map keep their own gestures: the pen, links and
 * buttons.
 */
export function isOnMap({ target }: Event): boolean {
  return target instanceof Element && target.closest("a, button, .sketch, .failure") === null;
}

function pointOf({ clientX, clientY }: MouseEvent): Point {
  return { x: clientX, y: clientY };
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function between(a: Point, b: Point): Point {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}
