/** The size of canvases in pixels, and its changes. */

export interface Size {
  width: number;
  height: number;
}

/** A canvas's own size, and its pixels per CSS pixel. */
export interface CanvasSize extends Size {
  ratio: number;
  /** The part of the map that the canvas shows; if undefined, the whole map fills it. */
  framing?: Framing;
}

/**
 * The part of a map that a picture shows: its western and northern edge, measured from the map's, and its width; then
 * how far other things cover it from its western, northern, eastern and southern edge. All in widths of the map.
 */
export type Framing = readonly [left: number, top: number, across: number, ...covered: number[]];

/** A place on the page, in CSS pixels. */
export interface Box extends Size {
  x: number;
  y: number;
}

/** The most pixels per CSS pixel. Beyond two nobody sees a difference, and painting takes four times as long. */
const RATIO_CAP = 2;
/** The most pixels of a canvas, 2048²: copying more takes longer than 2 ms of a frame. */
const AREA_CAP = 4_194_304;

/**
 * Returns the canvas's own size for a place on the page; 0 if it is not shown. Both edges are rounded to the nearest
 * pixel of the screen, as the browser does: a canvas of one pixel more or less would be stretched, and its lines
 * blurred.
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
 * Fits a canvas to an element. On two sides it may extend beyond it by a part of a pixel, which the element should
 * clip. The result depends on the element's size and not on its position, so that nothing blurs when it is moved
 * without an event.
 *
 * An element that a CSS transform makes smaller, such as a slide before it comes forward, counts with its layout size,
 * since no event is fired when the transform ends. One that is made larger counts as it is seen.
 */
export function fitOf(element: HTMLElement, devicePixelRatio: number): Fit {
  // Unlike offsetWidth this includes fractions of a pixel.
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

/** Returns the pixels per unit of a canvas, for a box of this area in square units. */
function pixelsPerUnit(area: number, devicePixelRatio: number): number {
  return Math.min(devicePixelRatio, RATIO_CAP, Math.sqrt(AREA_CAP / area));
}

/** The pause after which a resized picture is redrawn. While a window is dragged, the old picture is stretched. */
export const RESIZE_PAUSE_MS = 120;

/** Observes an element's size, in the screen's pixels if the browser can: between two screens only these change. */
export function observeSize(observer: ResizeObserver, element: Element): void {
  try {
    observer.observe(element, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(element);
  }
}
