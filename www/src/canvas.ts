/** How many pixels a canvas has. */

export interface Size {
  width: number;
  height: number;
}

/** Beyond two pixels to the CSS pixel nobody sees the difference, and painting takes four times as long. */
const RATIO_CAP = 2;
/** 2048²: copying more than this takes longer than 2 ms of a frame. */
const AREA_CAP = 4_194_304;

/** The canvas's own size for a size on the page; 0 when it is not shown at all. */
export function backingSize(css: Size, devicePixelRatio: number): Size {
  if (!(css.width > 0 && css.height > 0)) return { width: 0, height: 0 };
  const ratio = Math.min(devicePixelRatio, RATIO_CAP);
  const scale = Math.min(ratio, Math.sqrt(AREA_CAP / (css.width * css.height)));
  return { width: Math.max(1, Math.round(css.width * scale)), height: Math.max(1, Math.round(css.height * scale)) };
}
