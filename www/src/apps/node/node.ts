/**
 * The entry `riverseed/node`: makes files of finished maps in Node, without a page. The wasm module behind it is not
 * part of the interface.
 */

import { named, PageError } from "../../engine/errors.ts";
import { engine } from "../../engine/from-disk.ts";
import table from "../../engine/parameters.json";
import type { Parameter } from "../../engine/table.ts";
import type { Notice, Reading, ReadOptions, Summary } from "../../engine/types.ts";
import type { WholeRiver } from "../../engine/whole.ts";

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

/** A link, an address or a word as `readLink()` understands it. */
export interface ReadLink {
  /** The canonical link: it has the edition, so it names the same picture for ever, and a style if the text names one. */
  link: string;
  seed: string;
  /** Words for readers who do not see the picture, where its author gives none. */
  alternative: string;
  /** True if the text was damaged on its way, by a chat or by HTML, and has been mended. */
  isMended: boolean;
  /** What is beyond the element's limits, in words. If anything is, the element draws a smaller map than `grow()`. */
  beyondElement: string[];
}

/** Lists all parameters of a link with their ranges, choices and defaults. */
export function parameters(): Parameter[] {
  return structuredClone(table.parameters) as Parameter[];
}

/**
 * Grows the map of a link, such as `seed=kauri`, of a page's address or of a word. The call blocks meanwhile. Links are read strictly: a
 * `PageError` names any value that is unknown or out of range.
 */
export function grow(link: string): GrownMap {
  try {
    return new GrownMap(planted(link));
  } catch (error) {
    throw named(error);
  }
}

/** Reads a link as strictly as `grow()`, without growing its map. */
export function readLink(link: string): ReadLink {
  try {
    const { sharedLink, values, notices, alternative = "" } = readAs(link);
    refuse(notices, values);
    const seed = new Map(values).get("seed") ?? "";
    const beyondElement = readAs(link, { widget: true }).notices.filter(isFault).map(limitOf);
    return { link: sharedLink, seed, alternative, isMended: !notices.every(isFault), beyondElement };
  } catch (error) {
    throw named(error);
  }
}

function readAs(link: string, options?: ReadOptions): Reading {
  return engine().readLink(link, options);
}

function planted(link: string): WholeRiver {
  const { notices, values } = readAs(link);
  refuse(notices, values);
  return new (engine().River)(link);
}

function refuse(notices: readonly Notice[], values: Reading["values"]): void {
  const faults = notices.filter(isFault);
  if (faults.length === 0) return;
  const used = new Map(values);
  throw new PageError("bad-params", faults.map((notice) => faultOf(notice, used)).join("; "));
}

/** Returns whether a notice is of a fault in a recipe, and not of damage to a link that could be mended. */
function isFault({ key }: Notice): boolean {
  return key !== "link";
}

/**
 * Returns the part of a notice that names the fault. The rest says how the page repairs the link, which does not happen
 * here.
 */
function faultOf({ key, message }: Notice, used: ReadonlyMap<string, string>): string {
  const repair = [`: ${used.get(key) || "nothing"} is used`, ...REPAIRS].find((end) => message.endsWith(end));
  return repair ? message.slice(0, -repair.length) : message.replace(/^(\S+: .*?): .* is used$/s, "$1");
}

/** Returns what exceeds which limit: "… exceeds the widget's limit: 20000 is used" becomes "… the element's limit of 20000". */
function limitOf({ message }: Notice): string {
  return message.replace(/the widget's limit: (\S+) is used$/, "the element's limit of $1");
}

/** A finished map. */
class GrownMap {
  readonly #river: WholeRiver;

  constructor(river: WholeRiver) {
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
    return this.#river.svg();
  }

  /** Writes its rivers, lakes, basins and land, with their names and heights, as GeoJSON. */
  geojson(): GeoJson {
    const river = this.#river;
    while (river.raiseRelief());
    return river.geojson() as GeoJson;
  }

  /**
   * Lists the names of everything on it, whether or not the link shows labels: rivers first, the greatest before the
   * others.
   */
  names(): Name[] {
    return this.#river.greatest(ALL);
  }

  /** Frees its memory at once, rather than when JavaScript collects it. It cannot be used afterwards. */
  free(): void {
    this.#river.free();
  }
}

export type { GrownMap };

/** The other repairs, as the core words them. */
const REPAIRS = [
  ": it is left out",
  ": the rest is left out",
  ": the first is used",
  ": the first 40 are used",
  ": its beginning is used",
  ": the picture may differ from the one shared",
];
/** The number of steps between two checks whether it is finished. */
const STEPS = 1000;
/** A limit above any number of names. */
const ALL = 2 ** 32 - 1;
