/** Plain data that goes to a player and comes back: the map to show, and the map on the canvas. */

import type { Notice, Phase, ReadOptions, Summary } from "../engine/types.ts";
import type { State } from "./frame-loop.ts";

export type Canvas = HTMLCanvasElement | OffscreenCanvas;

/**
 * The way to show a map. watch: shows it grow and meander. settle: while a slider is dragged, shows the grown tree or a
 * draft of the rivers as soon as possible, and the finished rivers when the hand rests. still: shows finished rivers as
 * soon as possible.
 */
export type ShowMode = "watch" | "settle" | "still";

/** A link, with the options for reading it. */
export interface LinkToRead {
  text: string;
  options?: ReadOptions;
  /**
   * The letters that are carried along with the link; empty if there are none. Where this is left out, letters are placed for
   * each picture, and not in the steps of carried ones.
   */
  letters?: string;
  /** `true` if an engine has found that the map has names or trees, so that the smallest engine cannot show it. */
  isAnnotated?: boolean;
}

/** A link to change to. */
export interface Wanted {
  link: LinkToRead;
  how: ShowMode;
}

/** The link of the river on the canvas, as the core understood it. */
export interface Reading {
  /** The canonical link: what is drawn. */
  link: string;
  seed: string;
  aspect: number;
  /** The corrections that were needed. */
  notices: readonly Notice[];
  /** The number of links the player had been asked to show by then, without the first. */
  links: number;
}

/** The state of a map on its canvas, with its numbers. */
export interface Status {
  state: State;
  phase: Phase;
  /** The share of the way to the finished map, from 0 to 1. */
  progress: number;
  summary: Summary;
}
