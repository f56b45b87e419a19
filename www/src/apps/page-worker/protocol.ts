/** What the page and its renderer say to each other besides what everybody does who shows a river: questions, each with an answer. */

import type { Measure, RiverFacts } from "../../engine/full.ts";
import type { Format } from "../../files/format-names.ts";
import type { Thumbnail } from "../../player/thumbnails.ts";

/** The names on a map, as the engine tells them, three texts each. */
export interface Names {
  /** Of which map. */
  link: string;
  texts: readonly string[];
}

/** Where a river is: at a point in shares of the map, or as near as in widths of it; or by the mark of its name. */
export type RiverPlace = { x: number; y: number; reach: number } | { mark: string };

/** A river that was pointed at, with names in the place of marks; empty where something has none. */
export interface PointedRiver extends Omit<RiverFacts, "mark" | "into"> {
  /** Of which map. */
  link: string;
  /** Width and height of the map, in units. */
  size: readonly [width: number, height: number];
  mark: string;
  name: string;
  into: readonly string[];
}

/** A moment in the making of a map: a tick of growth, a round of meandering, or its end, whose step is 0. */
export interface Moment {
  part: "growth" | "bends" | "map";
  step: number;
}

/** How far a map has come, and what there is of its making. */
export interface Making {
  /** Of which map. */
  link: string;
  at: Moment;
  /** How far the part has come, from 0 to 1. */
  progress: number;
  /** How many ticks it grows, and the last round of meandering after which it is not finished; unknown until it was finished once. */
  lengths: { ticks: number; rounds: number } | undefined;
}

/** What can be laid over a map at any moment of its making, and what over a finished one. */
export type LiveOverlayName = "attractors" | "sources" | "reach" | "masks" | "captures";
export type OverlayName = LiveOverlayName | "orders" | "basins" | "flow" | "held" | "curvature";

/** Something laid over a map: paths of SVG, in units, some for each kind of thing that it tells apart. */
export interface Overlay {
  /** Of which map. */
  link: string;
  size: readonly [width: number, height: number];
  kinds: readonly (readonly string[])[];
  /** Of attractors: how many there are, and how many of them are left. */
  counts?: { all: number; left: number };
  /** How far an attractor pulls, and how near a river comes that uses it up, in units. */
  reaches?: readonly [reach: number, kill: number];
}

interface Questions {
  /** A link's finished rivers as a file; begun from the river of a number, as far as that has come, if there is one. */
  file: { of: number | undefined; link: string; format: Format };
  /** The greatest names of a river's finished map; none while it is not finished. */
  names: { of: number | undefined; count: number };
  /** The parameter `names` with another name for something, or its usual one. */
  renamed: { names: string; mark: string; name: string | undefined };
  /** Small pictures of a river's finished map, in their own pixels; none while it is not finished, or if it does not stay until they are made. */
  thumbnails: { of: number | undefined; styles: readonly string[]; size: { width: number; height: number } };
  /** What is measured of a river's finished map; none while it is not finished. */
  measures: { of: number | undefined };
  /** The river at a place of a river's finished map; none where there is none, and while it is not finished. */
  river: { of: number | undefined; place: RiverPlace };
  /** What can be laid over a river's map; none while there is none, as of most while that is not finished. */
  overlay: { of: number | undefined; name: OverlayName };
  /** How far a map has come; if a moment is given, once it has gone there, back or forth, or as far as it came before it was sent elsewhere. */
  making: { of: number | undefined; to: Moment | undefined };
  /** Nothing: what was said to a river before has been done. */
  now: { of: number };
}

export interface Answers {
  file: Blob;
  names: Names | undefined;
  renamed: string;
  thumbnails: readonly Thumbnail[] | undefined;
  measures: readonly Measure[] | undefined;
  river: PointedRiver | undefined;
  overlay: Overlay | undefined;
  making: Making | undefined;
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
