/** How many pixels a canvas has, and when that changes. */

export interface Size {
  width: number;
  height: number;
}

/** A canvas's own size, and how many of its pixels are one CSS pixel. */
export interface CanvasSize extends Size {
  ratio: number;
  /** All that covers the canvas, without one. */
  framing?: Framing;
}

/**
 * What part of a map a picture shows: how far its western edge lies east of the map's and its northern edge south of the map's, and how wide it
 * is; and how much other things cover of its western, northern, eastern and southern edge. All in widths of the map.
 */
export type Framing = readonly [left: number, top: number, across: number, ...covered: number[]];

/** A place on the page, in CSS pixels. */
export interface Box extends Size {
  x: number;
  y: number;
}

/** Beyond two pixels to the CSS pixel nobody sees the difference, and painting takes four times as long. */
const RATIO_CAP = 2;
/** 2048²: copying more than this takes longer than 2 ms of a frame. */
const AREA_CAP = 4_194_304;

/**
 * The canvas's own size for a place on the page; 0 when it is not shown at all. Both edges go to the nearest pixel of
 * the screen, as the browser does with them: a canvas of one pixel more or less would be stretched, and all lines soft.
 */
export function backingSize({ x, y, width, height }: Box, devicePixelRatio: number): Size {
  if (!(width > 0 && height > 0)) return { width: 0, height: 0 };
  const scale = pixelsPerUnit(width * height, devicePixelRatio);
  const pixels = (from: number, length: number) =>
    Math.max(1, Math.round((from + length) * scale) - Math.round(from * scale));
  return { width: pixels(x, width), height: pixels(y, height) };
}

/** A canvas's own size, and the CSS pixels that it takes up, so that each of its pixels is one of the screen's. */
export interface Fit {
  pixels: Size;
  css: Size;
}

/**
 * How a canvas covers an element: with a part of a pixel on two sides, which the element is to clip. Depends on the element's size
 * alone, not on where it begins, so that nothing turns soft when it is moved without a word.
 *
 * Made smaller by a CSS transform, as slides and cards are before they come forward, an element counts as large as it is laid out:
 * no event comes when the transform ends. Made larger it counts as it is seen.
 */
export function fitOf(element: HTMLElement, devicePixelRatio: number): Fit {
  // Unlike offsetWidth with what there is behind the point.
  const laidOut = each(getComputedStyle(element), Number.parseFloat);
  const area = areaOf(laidOut);
  if (!(area > 0)) return NOT_SHOWN;
  const enlargement = Math.sqrt(areaOf(element.getBoundingClientRect()) / area);
  // Less than a hundredth is noise.
  const scale = enlargement > 1.01 ? enlargement : 1;
  const ratio = scale * pixelsPerUnit(area * scale * scale, devicePixelRatio);
  // Browsers lay out in 64ths of a pixel, and round what they report: this much over a whole one is none.
  const pixels = each(laidOut, (length) => Math.ceil(length * ratio - 1 / 32));
  return { pixels, css: each(pixels, (length) => length / ratio) };
}

const NOT_SHOWN: Fit = { pixels: { width: 0, height: 0 }, css: { width: 0, height: 0 } };

function areaOf({ width, height }: Size): number {
  return width * height;
}

function each<T>({ width, height }: { width: T; height: T }, map: (length: T) => number): Size {
  return { width: map(width), height: map(height) };
}

/** How many pixels a canvas has to the unit, for a box of this area in square units. */
function pixelsPerUnit(area: number, devicePixelRatio: number): number {
  return Math.min(devicePixelRatio, RATIO_CAP, Math.sqrt(AREA_CAP / area));
}

/** While a window is dragged wider the old picture is stretched; it is redrawn when the hand rests this long. */
export const RESIZE_PAUSE_MS = 120;

/** Follows a place's size, in the screen's pixels if the browser can: they change alone between two screens. */
export function observeSize(observer: ResizeObserver, element: Element): void {
  try {
    observer.observe(element, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(element);
  }
}
