/** The formats of data and shapes that the page offers, named by their file extension; `formats.ts` makes them. */

export const FORMATS = ["svg", "geojson", "json", "zip"] as const;

export type Format = (typeof FORMATS)[number];
