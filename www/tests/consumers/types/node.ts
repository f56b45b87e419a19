/** Finished maps in Node. */

import { type GeoJson, type GrownMap, grow, type Name, PageError, parameters } from "riverseed/node";

export function filesOf(link: string): { svg: string; geojson: GeoJson; names: readonly Name[]; sources: number } {
  const map: GrownMap = grow(link);
  try {
    return { svg: map.svg(), geojson: map.geojson(), names: map.names(), sources: map.summary.sources };
  } finally {
    map.free();
  }
}

export const ranges: [key: string, min: number | undefined, max: number | undefined][] = parameters().map(
  ({ key, min, max }) => [key, min, max],
);

export function isRefused(link: string): boolean {
  try {
    grow(link).free();
    return false;
  } catch (error) {
    return error instanceof PageError && error.code === "bad-params";
  }
}

// @ts-expect-error: a link is text.
grow(7);
