/** Plain data that go to a player and come back: the map to show, and the map on the canvas. */

import type { Notice, ReadOptions } from "../engine/types.ts";

export type Canvas = HTMLCanvasElement | OffscreenCanvas;

/**
 * watch: shows it grow and meander; settle: for a slider that is being dragged, shows the grown tree or a draft of the rivers as soon as may
 * be, and the finished rivers when the hand rests; still: shows nothing but finished rivers.
 */
export type ShowMode = "watch" | "settle" | "still";

/** A link, and where its rivers are to be seen. */
export interface LinkToRead {
  text: string;
  options?: ReadOptions;
}

/** A link to go over to. */
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
  /** How many links the player had been asked to show by then, the first not counted. */
  links: number;
}
