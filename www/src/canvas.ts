/** How many pixels a canvas has, and when that changes. */

export interface Size {
  width: number;
  height: number;
}

/** A place on the page, in CSS pixels. */
export interface Box extends Size {
  x: number;
  y: number;
}

/**
 * An element's place on the page. Made smaller by a CSS transform, as slides and cards are before they come forward, it counts as
 * large as it is laid out: nobody is told when the transform ends, and a picture of less pixels would stay soft. Made larger it
 * counts as it is seen.
 */
export function placeOf(element: HTMLElement): Box {
  const seen = element.getBoundingClientRect();
  const { offsetWidth, offsetHeight } = element;
  if (Math.abs(seen.width - offsetWidth) < 1 && Math.abs(seen.height - offsetHeight) < 1) return seen;
  // Unlike offsetWidth with what there is behind the point.
  const { width, height } = getComputedStyle(element);
  const laid = { width: Number.parseFloat(width), height: Number.parseFloat(height) };
  const scale = Math.max(1, Math.sqrt((seen.width * seen.height) / (laid.width * laid.height)));
  return { x: seen.x, y: seen.y, width: laid.width * scale, height: laid.height * scale };
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
  const ratio = Math.min(devicePixelRatio, RATIO_CAP);
  const scale = Math.min(ratio, Math.sqrt(AREA_CAP / (width * height)));
  const pixels = (from: number, length: number) =>
    Math.max(1, Math.round((from + length) * scale) - Math.round(from * scale));
  return { width: pixels(x, width), height: pixels(y, height) };
}

/** While a window is dragged wider the old picture is stretched; it is drawn anew when the hand rests this long. */
export const RESIZE_PAUSE_MS = 120;

/** Follows a place's size, in the screen's pixels if the browser can: they change alone between two screens. */
export function observeSize(observer: ResizeObserver, element: Element): void {
  try {
    observer.observe(element, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(element);
  }
}
