/**
 * The camera: the part of the map that the picture shows, and the map's place on the page. Lengths on the page are in
 * CSS pixels.
 */

import type { Box, Framing, Size } from "../../../browser/canvas.ts";

/** The part of the picture's place that other things cover, from each side. */
export interface Insets {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** A picture's place: its size, the part that is covered, and the map's width over its height. */
export interface Stage extends Size {
  insets: Insets;
  aspect: number;
}

/** The bounds of a part of the map, in shares of its sides. */
export interface Bounds {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Point {
  x: number;
  y: number;
}

/** The closest zoom. At 1 the whole map is seen; at the closest a stream is as wide as a hand. */
const MOST_ZOOM = 16;
/** A part of the map that could be shown only a little larger is not worth hiding the rest. */
const LEAST_GAIN = 1.1;
/** The smallest width of the map as a share of its place, however much is covered. */
const LEAST_SHARE = 1 / 18;

export class Camera {
  #zoom = 1;
  /** The point of the map in the middle of the free part, in shares of its sides. */
  #at: Point = { x: 0.5, y: 0.5 };

  /** True while the whole map is seen. */
  get showsAll(): boolean {
    return this.#zoom === 1;
  }

  get isClosest(): boolean {
    return this.#zoom === MOST_ZOOM;
  }

  /** Shows the whole map. */
  reset(): void {
    this.#zoom = 1;
    this.#at = { x: 0.5, y: 0.5 };
  }

  /** Shows a part of the map as large as its place allows. */
  show({ left, top, right, bottom }: Bounds, stage: Stage): void {
    const { across, down } = freePartOf(stage);
    const width = widthOf(stage);
    const zoom = Math.min(across / ((right - left) * width), (down * stage.aspect) / ((bottom - top) * width));
    if (zoom < LEAST_GAIN) return;
    this.#zoom = Math.min(MOST_ZOOM, zoom);
    this.#at = { x: (left + right) / 2, y: (top + bottom) / 2 };
  }

  /** Returns the place of the map on the page. */
  boxOn(stage: Stage): Box {
    const width = widthOf(stage) * this.#zoom;
    const height = width / stage.aspect;
    const { x, y } = middleOf(stage);
    return { x: x - this.#at.x * width, y: y - this.#at.y * height, width, height };
  }

  /** Returns the part of the map that the picture shows. */
  framingOn(stage: Stage): Framing {
    const { x, y, width } = this.boxOn(stage);
    const { left, top, right, bottom } = stage.insets;
    const covered = [left, top, right, bottom].map((inset) => Math.min(inset, stage.width) / width);
    return [-x / width, -y / width, stage.width / width, ...covered];
  }

  /** Zooms in or out about a point of the page, which stays where it is. */
  zoomBy(factor: number, about: Point | undefined, stage: Stage): void {
    const { x, y } = about ?? middleOf(stage);
    const before = this.boxOn(stage);
    const zoom = Math.min(MOST_ZOOM, Math.max(1, this.#zoom * factor));
    const grown = zoom / this.#zoom;
    this.#zoom = zoom;
    this.#put({ x: x + (before.x - x) * grown, y: y + (before.y - y) * grown }, stage);
  }

  /** Moves the map over the page. */
  moveBy(dx: number, dy: number, stage: Stage): void {
    const { x, y } = this.boxOn(stage);
    this.#put({ x: x + dx, y: y + dy }, stage);
  }

  /**
   * Puts the map's corner at a point of the page, but keeps some of the map in the middle. A map that is seen whole has
   * only one place.
   */
  #put(corner: Point, stage: Stage): void {
    if (this.showsAll) {
      this.reset();
      return;
    }
    const { width, height } = this.boxOn(stage);
    const middle = middleOf(stage);
    const share = (length: number): number => Math.min(1, Math.max(0, length));
    this.#at = { x: share((middle.x - corner.x) / width), y: share((middle.y - corner.y) / height) };
  }
}

/** Returns the width of the map when the whole map is seen. */
function widthOf(stage: Stage): number {
  const { across, down } = freePartOf(stage);
  return Math.max(Math.min(across, down * stage.aspect), stage.width * LEAST_SHARE);
}

function freePartOf({ width, height, insets }: Stage): { across: number; down: number } {
  return { across: width - insets.left - insets.right, down: height - insets.top - insets.bottom };
}

function middleOf({ width, height, insets }: Stage): Point {
  return { x: (width + insets.left - insets.right) / 2, y: (height + insets.top - insets.bottom) / 2 };
}

/** Returns the transform that makes a picture with one framing stand in for another, in a place of this width. */
export function transformBetween(shown: Framing, wanted: Framing, width: number): string {
  const scale = shown[2] / wanted[2];
  const [x, y] = [0, 1].map((axis) => (((shown[axis] ?? 0) - (wanted[axis] ?? 0)) / wanted[2]) * width);
  return scale === 1 && x === 0 && y === 0 ? "" : `translate(${x}px, ${y}px) scale(${scale})`;
}
