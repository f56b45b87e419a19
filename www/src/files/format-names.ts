/** The formats of data and shapes that the page offers, named by their file extension; `formats.ts` makes them. */

interface FormatFacts {
  /** The name and the use, for visitors. */
  words: readonly [name: string, help: string];
  /** True if the file depends on the style. */
  isStyled: boolean;
}

export type Format = "svg" | "geojson" | "json" | "zip";

export const FORMATS: Readonly<Record<Format, FormatFacts>> = {
  svg: { words: ["Drawing (SVG)", "lines, for any size and for drawing on"], isStyled: true },
  geojson: { words: ["Map data (GeoJSON)", "rivers, lakes, basins and land, for maps and GIS"], isStyled: false },
  json: { words: ["Network (JSON)", "all that is known of the rivers, for programs"], isStyled: false },
  zip: { words: ["Game pack (ZIP)", "heights, masks, flow and rivers, for games"], isStyled: true },
};

export const FORMAT_NAMES = Object.keys(FORMATS) as Format[];

export function isFormat(name: string): name is Format {
  return name in FORMATS;
}

/** The size and shape of a game pack's rasters. */
export interface RasterOrder {
  /** In pixels. */
  longerSide: number;
  /** True for squares, with the map in the middle and sea around it. */
  isSquare: boolean;
}
