/** The page's part of the messages with its renderer: questions, each with an answer. */

import type { Kind } from "../../engine/mark.ts";
import type {
  LakeFacts,
  Making as Lengths,
  Lengths as MapLengths,
  MapPromise,
  Measure,
  Moment,
  NameFacts,
  RiverFacts,
} from "../../engine/types.ts";
import type { Format, RasterOrder } from "../../files/format-names.ts";
import type { Picture, Thumbnail } from "../../player/thumbnails.ts";

/** The names on a map. */
export interface Names {
  /** The link of the map. */
  link: string;
  names: readonly NameFacts[];
}

/**
 * A river's place: within `reach`, in widths of the map, of a point in shares of the map's sides; or the mark of its
 * name.
 */
export type RiverPlace = { x: number; y: number; reach: number } | { mark: string };

/** A river that was pointed at, with names in place of marks; empty for those without a name. */
export interface PointedRiver extends Omit<RiverFacts, "mark" | "into" | "isBasinSmall" | "lake"> {
  /** The link of the map. */
  link: string;
  /** Width and height of the map, in units. */
  size: readonly [width: number, height: number];
  mark: string;
  name: string;
  into: readonly string[];
  /** The lake that is pointed at, out of which the river runs, with its name; empty if it has none. */
  lake?: LakeFacts & { name: string };
}

/** Something on the map that has a name or could have one. */
export interface Nameable {
  /** The mark by which links know it. */
  mark: string;
  kind: Kind;
  /** Empty if it has none. */
  name: string;
  /** The line along which it lies, or its name: x and y in turn, in shares of the map's sides. */
  line: ArrayLike<number>;
  /** The size of the letters, in widths of the map, if the line is that of its name. */
  em?: number;
}

/** A place that was clicked, or the mark of one thing. Letters count only if they are shown. */
export type NameablePlace = { x: number; y: number; reach: number; hasLabels: boolean } | { mark: string };

/** The things that have names at a place, the nearest first. */
export interface Nameables {
  /** The link of the map. */
  link: string;
  /** Width and height of the map, in units. */
  size: readonly [width: number, height: number];
  things: readonly Nameable[];
  /** The marks of rivers and meanders whose names stand on the picture. */
  labelled: readonly string[];
}

export type { Moment } from "../../engine/types.ts";

/** The progress of a map, and the lengths of its making. */
export interface Making {
  /** The link of the map. */
  link: string;
  at: Moment;
  /** The progress of the part, from 0 to 1. */
  progress: number;
  /** How long it is; unknown until it has been finished once. */
  lengths: Lengths | undefined;
}

/** The overlays of a map at any moment of its making; below, those of a finished map as well. */
export type LiveOverlayName = "attractors" | "sources" | "reach" | "masks" | "captures" | "cut";
export type OverlayName = LiveOverlayName | "orders" | "basins" | "flow" | "held" | "curvature";

/** An overlay of a map: SVG paths in units, a list for each kind of thing it shows. */
export interface Overlay {
  /** The link of the map. */
  link: string;
  size: readonly [width: number, height: number];
  kinds: readonly (readonly string[])[];
  /** The numbers of attractors in all and of those that are left. */
  counts?: { all: number; left: number };
  reaches?: Reaches;
}

/** The distances within which an attractor pulls a river, and is used up by one, and a kilometre, all in units. */
export type Reaches = Pick<MapLengths, "reach" | "kill" | "kilometre">;

/** The bounds of a land, in shares of the map's sides. */
export interface LandBounds {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

interface Questions {
  /**
   * Makes a file of a link's finished rivers, starting from the river of `of`, if there is one. `rasters` is for a game
   * pack; without it, they have the map's own cells.
   */
  file: { of: number | undefined; link: string; format: Format; rasters?: RasterOrder | undefined };
  /** Asks for the greatest names of a river's finished map; none while it is not finished. */
  names: { of: number | undefined; count: number };
  /** Asks for the letters to carry along with a link of a river's finished map; none while it is not finished. */
  letters: { of: number | undefined; link: string };
  /** Asks for the parameter `names` with another name for something, or its usual one. */
  renamed: { names: string; mark: string; name: string | undefined };
  /**
   * Asks for thumbnails of a river's finished map, with `size` in device pixels; none while it is not finished, or if
   * it changes before they are made.
   */
  thumbnails: { of: number | undefined; styles: readonly string[]; size: { width: number; height: number } };
  /**
   * Asks for a small picture of another map, finished, with `size` in device pixels; none if the river of `of` changes
   * before it is made.
   */
  picture: { of: number | undefined; link: string; size: { width: number; height: number } };
  /** Asks for the measures of a river's finished map and what was found of its promises; none while it is not finished. */
  measures: { of: number | undefined };
  /** Asks for the river at a place of a finished map; none where there is none, and while it is not finished. */
  river: { of: number | undefined; place: RiverPlace };
  /** Asks what has a name, or could have one, at a place of a finished map; none while it is not finished. */
  nameables: { of: number | undefined; place: NameablePlace };
  /** Asks for an overlay of a river's map. Most have none while the map is not finished. */
  overlay: { of: number | undefined; name: OverlayName };
  /**
   * Asks for the progress of a map. If a moment is given, it goes there first, unless another question sends it
   * elsewhere meanwhile.
   */
  making: { of: number | undefined; to: Moment | undefined };
  /** Asks for the bounds of the land that a river has at present; none if all is land, or if there is no such river. */
  land: { of: number | undefined };
  /** Asks for nothing. The answer means that all earlier commands have been carried out. */
  now: { of: number };
}

/** What is measured of a map, and what was found of the promises that every map keeps. */
export interface Measured {
  measures: readonly Measure[];
  promises: readonly MapPromise[];
}

export interface Answers {
  file: Blob;
  names: Names | undefined;
  letters: string | undefined;
  renamed: string;
  thumbnails: readonly Thumbnail[] | undefined;
  picture: Picture | undefined;
  measures: Measured | undefined;
  river: PointedRiver | undefined;
  nameables: Nameables | undefined;
  overlay: Overlay | undefined;
  making: Making | undefined;
  land: LandBounds | undefined;
  now: undefined;
}

export type About = keyof Answers;
export type QuestionAbout<Key extends About> = Questions[Key] & { about: Key };
export type Question = { [Key in About]: QuestionAbout<Key> }[About];
export type Answer = Answers[About];

/** The first message to a worker: the engine, which the page has compiled. */
export interface Init {
  engine: WebAssembly.Module;
}
