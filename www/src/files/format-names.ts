/** The formats of data and shapes that the page offers, named by their file extension; `formats.ts` makes them. */

export const FORMATS = ["svg", "geojson", "json", "zip"] as const;

/** The size and shape of a game pack's rasters. */
export interface RasterOrder {
  /** In pixels. */
  longerSide: number;
  /** True for squares, with the map in the middle and sea around it. */
  isSquare: boolean;
}

export type Format = (typeof FORMATS)[number];
