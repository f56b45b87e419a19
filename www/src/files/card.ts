/** Makes the pictures with the map's title, which are sent and posted: all of the land, and letters that can be read. */

import type { WholeRiver } from "../engine/whole.ts";
import { CARDS, type CardOrder, changed } from "./order.ts";

/** Returns the link of such a picture: the map without its own title, and with few labels if it has any. */
export function cardLink(link: string): string {
  const isBare = new URLSearchParams(link).get("labels") === "none";
  return changed(link, { cartouche: "none", labels: isBare ? "none" : "few" });
}

/** Gives the picture of a grown river its size, its part of the map and its title. */
export function composeCard(kind: CardOrder["kind"], river: WholeRiver): void {
  const { width, height } = CARDS[kind];
  river.resize(width, height);
  river.head();
}
