/** The formats that the page offers, each named as its files end; `formats.ts` makes them. */

export const FORMATS = ["png", "svg", "geojson", "json", "zip"] as const;

export type Format = (typeof FORMATS)[number];

export function isFormat(name: string | undefined): name is Format {
  return FORMATS.some((format) => format === name);
}
