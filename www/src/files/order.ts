/** Orders for pictures and videos of a map: plain data, since they go to a worker. */

import type { Code } from "../engine/errors.ts";

/** A picture of all of the map. */
export interface PictureOrder {
  kind: "picture";
  link: string;
  /** In pixels. */
  longerSide: number;
  /** In pixels, for a picture with the shape of a sheet of paper; without it, a picture has the map's shape. */
  shorterSide?: number;
  /** Dots per inch, for a picture that is made for print. */
  dpi?: number;
  /** True to leave out the sea, or in line styles the paper. */
  isTransparent: boolean;
}

/** A picture with all of the land and the map's title, to send and to post. */
export interface CardOrder {
  kind: "card" | "portrait";
  link: string;
}

/** The growth as a video of six seconds. */
export interface AnimationOrder {
  kind: "animation";
  link: string;
}

export type Order = PictureOrder | CardOrder | AnimationOrder;

/** A worker's message: that it is ready, the progress of the file, the file, or a failure. */
export type Said =
  | { is: "open" }
  | { is: "at"; share: number }
  | { is: "made"; file: Blob }
  | { is: "failed"; code: Code; message: string };

/** The longer side of pictures in pixels, by use; below, the range of custom sizes. */
export const SIZES = { screen: 2000, a4: 3508, a3: 4961, poster: 8192 } as const;
export const OWN_SIZES = { min: 256, max: 8192 } as const;

/** The dots per inch of good print. */
export const PRINT_DPI = 300;

/** A sheet of paper: the shorter side in pixels, and the dots per inch at which its picture fills it. */
export interface Sheet {
  paper: string;
  shorterSide: number;
  dpi: number;
}

/** The sheets by size. The largest picture there may be is not as fine as good print on A1, but a poster is seen from afar. */
export const SHEETS: Partial<Record<keyof typeof SIZES, Sheet>> = {
  a4: { paper: "A4", shorterSide: 2480, dpi: PRINT_DPI },
  a3: { paper: "A3", shorterSide: 3508, dpi: PRINT_DPI },
  poster: { paper: "A1", shorterSide: 5786, dpi: 247.4 },
};

/**
 * The sizes in pixels of the pictures with a title: the card, which social networks show for a link, and the portrait,
 * which fills a phone.
 */
export const CARDS = {
  card: { width: 1200, height: 630 },
  portrait: { width: 1200, height: 1500 },
} as const;

/** Returns a link without labels and cartouche. */
export function withoutNames(link: string): string {
  return changed(link, { labels: "none", cartouche: "none" });
}

/** Returns a link with other values; keys with an undefined value get their default. */
export function changed(link: string, values: Record<string, string | undefined>): string {
  const all = new URLSearchParams(link);
  for (const [key, value] of Object.entries(values)) {
    if (value === undefined) all.delete(key);
    else all.set(key, value);
  }
  return all.toString();
}
