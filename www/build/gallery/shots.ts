/** The pictures of a map in the site, and their sizes. */

import { Camera, type Insets } from "../../src/apps/page/map/camera.ts";
import type { Size } from "../../src/browser/canvas.ts";

/** A picture of a map, as an order for scripts/draw-maps.mjs. */
export interface Shot extends Size {
  readonly format: "webp" | "jpeg";
  readonly quality: number;
  /** The part of the map that it shows, as for `River.frame`; if undefined, the map from edge to edge. */
  readonly framing?: readonly number[];
  /** Its pixels to one of those that letters are measured in; 1 if undefined. */
  readonly ratio?: number;
  /** The title in its lower left corner. */
  readonly title?: string;
}

/** The size of the picture that chats and social networks show for a link. Most of them show this size whole. */
export const CARD: Size = { width: 1200, height: 630 };
/** The margins of a map on a card, with its name below. */
const CARD_INSETS: Insets = { left: 40, top: 36, right: 40, bottom: 104 };
/** Lands that are shown whole on a card, since the sea is all around them. Others fill the card. */
const WHOLE_LANDS = ["island", "archipelago", "crescent", "twins", "long", "arms"];

/** The number of pixels of a map in the overview, and on its own page, whatever its shape. */
const OVERVIEW_AREA = 640 * 400;
const PAGE_AREA = 1200 * 750;

export function overviewShot(aspect: number): Shot {
  return { ...sizeOf(aspect, OVERVIEW_AREA), format: "webp", quality: 72 };
}

export function pageShot(aspect: number): Shot {
  return { ...sizeOf(aspect, PAGE_AREA), format: "webp", quality: 80 };
}

/** Returns the card: the map with its name. */
export function cardShot(aspect: number, title: string, land: string): Shot {
  const framing = WHOLE_LANDS.includes(land)
    ? new Camera().framingOn({ ...CARD, insets: CARD_INSETS, aspect })
    : filling(aspect);
  return { ...CARD, format: "jpeg", quality: 80, title, framing };
}

/** Returns the framing in which the middle of a map fills a card. */
function filling(aspect: number): number[] {
  const { width, height } = CARD;
  const across = Math.max(width, height * aspect);
  const down = across / aspect;
  return [(across - width) / 2, (down - height) / 2, width, 0, 0, 0, CARD_INSETS.bottom].map((px) => px / across);
}

function sizeOf(aspect: number, area: number): Size {
  return { width: Math.round(Math.sqrt(area * aspect)), height: Math.round(Math.sqrt(area / aspect)) };
}
