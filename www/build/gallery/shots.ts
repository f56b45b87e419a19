/** Which pictures of a map the site has, and how large they are. */

import { Camera, type Insets } from "../../src/apps/page/map/camera.ts";
import type { Size } from "../../src/browser/canvas.ts";

/** A picture of a map as it is asked of scripts/draw-maps.mjs. */
export interface Shot extends Size {
  readonly format: "webp" | "jpeg";
  readonly quality: number;
  /** What it shows, as `River.frame` takes it; nothing: the map from edge to edge. */
  readonly framing?: readonly number[];
  /** What is written in its lower left corner. */
  readonly title?: string;
}

/** What chats and social networks show of a link: in this size most of them show all of it. */
export const CARD: Size = { width: 1200, height: 630 };
/** Below the map on a card stands its name. */
const CARD_INSETS: Insets = { left: 40, top: 36, right: 40, bottom: 104 };
/** Lands with the sea all around are seen whole on a card. Others would end somewhere: they fill it. */
const WHOLE_LANDS = ["island", "archipelago"];

/** As many pixels have all maps in the overview, and on their own pages, whatever their shape. */
const OVERVIEW_AREA = 640 * 400;
const PAGE_AREA = 1200 * 750;

export function overviewShot(aspect: number): Shot {
  return { ...sizeOf(aspect, OVERVIEW_AREA), format: "webp", quality: 72 };
}

export function pageShot(aspect: number): Shot {
  return { ...sizeOf(aspect, PAGE_AREA), format: "webp", quality: 80 };
}

/** The map with its name. */
export function cardShot(aspect: number, title: string, land: string): Shot {
  const framing = WHOLE_LANDS.includes(land)
    ? new Camera().framingOn({ ...CARD, insets: CARD_INSETS, aspect })
    : filling(aspect);
  return { ...CARD, format: "jpeg", quality: 80, title, framing };
}

/** The middle of a map on all of a card. */
function filling(aspect: number): number[] {
  const { width, height } = CARD;
  const across = Math.max(width, height * aspect);
  const down = across / aspect;
  return [(across - width) / 2, (down - height) / 2, width, 0, 0, 0, CARD_INSETS.bottom].map((px) => px / across);
}

function sizeOf(aspect: number, area: number): Size {
  return { width: Math.round(Math.sqrt(area * aspect)), height: Math.round(Math.sqrt(area / aspect)) };
}
