/**
 * The entry `riverseed/node`: makes files of finished maps in Node, without a page. The wasm modules behind it are not
 * part of the interface.
 */

import { named, PageError } from "../../engine/errors.ts";
import { engine, teller, writer } from "../../engine/from-disk.ts";
import table from "../../engine/parameters.json";
import type { Parameter } from "../../engine/table.ts";
import type { Notice, River, Summary } from "../../engine/types.ts";
import { askMap, writeMap } from "../../player/asking.ts";

export { PageError } from "../../engine/errors.ts";
export type { Parameter } from "../../engine/table.ts";
export type { Summary } from "../../engine/types.ts";

/** The name of something on a map. */
export interface Name {
  /** Its mark in a link's `names`. */
  mark: string;
  name: string;
  /** True if the link gives it this name. */
  isOwn: boolean;
}

/** A map as GeoJSON. */
export interface GeoJson {
  type: "FeatureCollection";
  features: {
    type: "Feature";
    geometry: { type: string; coordinates: unknown } | null;
    properties: Record<string, unknown> | null;
  }[];
}

/** Lists all parameters of a link with their ranges, choices and defaults. */
export function parameters(): Parameter[] {
  return structuredClone(table.parameters) as Parameter[];
}

/**
 * Grows the map of a link, such as `seed=kauri`. The call blocks meanwhile. Links are read strictly: a
 * `PageError` names any value that is unknown or out of range.
 */
export function grow(link: string): GrownMap {
  try {
    return new GrownMap(planted(link));
  } catch (error) {
    throw named(error);
  }
}

function planted(link: string): River {
  const { River } = engine();
  const river = new River(link);
  const { notices } = river;
  if (notices.length === 0) return river;
  river.free();
  throw new PageError("bad-params", notices.map(({ message }: Notice) => message).join("; "));
}

/** A finished map. */
class GrownMap {
  readonly #river: River;

  constructor(river: River) {
    this.#river = river;
    while (river.advance(STEPS));
  }

  /** Its canonical link, without defaults. */
  get link(): string {
    return this.#river.link;
  }

  /** Its numbers. */
  get summary(): Summary {
    return this.#river.summary();
  }

  /** Writes it as an SVG file. */
  svg(): string {
    return writeMap(this.#river, writer(), (map) => map.svg());
  }

  /** Writes its rivers, lakes, basins and land, with their names and heights, as GeoJSON. */
  geojson(): GeoJson {
    const river = this.#river;
    while (river.raiseRelief());
    return writeMap(river, writer(), (map) => map.geojson()) as GeoJson;
  }

  /**
   * Lists the names of everything on it, whether or not the link shows labels: rivers first, the greatest before the
   * others.
   */
  names(): Name[] {
    const flat = askMap(this.#river, teller(), (map) => map.greatest(ALL));
    const names: Name[] = [];
    for (let i = 0; i + 2 < flat.length; i += 3) {
      const [mark = "", name = "", own] = flat.slice(i, i + 3);
      names.push({ mark, name, isOwn: own === "own" });
    }
    return names;
  }

  /** Frees its memory at once, rather than when JavaScript collects it. It cannot be used afterwards. */
  free(): void {
    this.#river.free();
  }
}

export type { GrownMap };

/** The number of steps between two checks whether it is finished. */
const STEPS = 1000;
/** A limit above any number of names. */
const ALL = 2 ** 32 - 1;
