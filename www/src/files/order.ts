/** What can be made of a map in pictures, as whoever asks for it says it: plain data, since it goes to a worker. */

import type { Code } from "../engine/errors.ts";

/** A picture of all of the map. */
export interface PictureOrder {
  kind: "picture";
  link: string;
  /** In pixels. */
  longerSide: number;
  /** Without the sea, or in styles of lines the paper. */
  isTransparent: boolean;
}

/** A picture with the map's title, for posts and for what social networks show of a link. */
export interface CardOrder {
  kind: "card";
  link: string;
}

/** The growth as a video of six seconds. */
export interface AnimationOrder {
  kind: "animation";
  link: string;
}

export type Order = PictureOrder | CardOrder | AnimationOrder;

/** A worker's message: that it is there, how far the file is, or the file. */
export type Said =
  | { is: "open" }
  | { is: "at"; share: number }
  | { is: "made"; file: Blob }
  | { is: "failed"; code: Code; message: string };

/** The sizes of pictures: by use, and the range of those of one's own; the longer side, in pixels. */
export const SIZES = { screen: 2000, a4: 3508, a3: 4961, poster: 8192 } as const;
export const OWN_SIZES = { min: 256, max: 8192 } as const;

/** The size of the picture that social networks show of a link, in pixels. */
export const CARD = { width: 1200, height: 630 } as const;

/** A link but for what is written on its map. */
export function withoutNames(link: string): string {
  return changed(link, { labels: undefined, cartouche: undefined });
}

/** A link with other values; with the usual ones, where there are none. */
export function changed(link: string, values: Record<string, string | undefined>): string {
  const all = new URLSearchParams(link);
  for (const [key, value] of Object.entries(values)) {
    if (value === undefined) all.delete(key);
    else all.set(key, value);
  }
  return all.toString();
}
