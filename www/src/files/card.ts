/** Makes the pictures with the map's title, which are sent and posted: all of the land, and letters that can be read. */

import type { WholeRiver } from "../engine/whole.ts";
import { composed, shownOf } from "./composition.ts";
import { CARDS, type CardOrder, changed } from "./order.ts";

/** How wide chats and feeds show these pictures, in CSS pixels: what could not be read there is left out. */
const SEEN_WIDTH_PX = 300;

/** Returns the link of such a picture: the map without its own title, and with few labels if it has any. */
export function cardLink(link: string): string {
  const isBare = new URLSearchParams(link).get("labels") === "none";
  return changed(link, { cartouche: "none", labels: isBare ? "none" : "few" });
}

/** Gives the picture of a grown river its size, its part of the map and its title. */
export function composeCard(kind: CardOrder["kind"], river: WholeRiver): void {
  const { width, height } = CARDS[kind];
  const { left, top, right, bottom } = river.landBounds();
  const { framing, title } = composed(CARDS[kind], shownOf([left, top, right, bottom], river.aspect));
  river.resize(width, height);
  river.frame(new Float32Array(framing));
  river.head(width / SEEN_WIDTH_PX, ...title);
}
