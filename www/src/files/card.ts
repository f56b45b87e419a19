/** Makes the pictures with the map's title, which are sent and posted: all of the land, and letters that can be read. */

import type { SteeredRiver } from "../engine/steer.ts";
import { askMap, required } from "../player/asking.ts";
import { composed, type Edges, shownOf } from "./composition.ts";
import type { Course } from "./course.ts";
import { CARDS, type CardOrder, changed } from "./order.ts";
import { type MakerCore, painted } from "./painting.ts";

/** How wide chats and feeds show these pictures, in CSS pixels: what could not be read there is left out. */
const SEEN_WIDTH_PX = 300;

/** Returns the link of such a picture: the map without its own title, and with few labels if it has any. */
export function cardLink(link: string): string {
  const isBare = new URLSearchParams(link).get("labels") === "none";
  return changed(link, { cartouche: "none", labels: isBare ? "none" : "few" });
}

/** Paints the picture of a grown river. */
export async function paintCard(
  kind: CardOrder["kind"],
  river: SteeredRiver,
  core: MakerCore,
  course: Course,
): Promise<void> {
  const { width, height } = CARDS[kind];
  river.resize(width, height);
  const teller = await required(core.loadTeller);
  const masks = askMap(river, teller, (map) => {
    const { framing, title } = composed(CARDS[kind], shownOf(edges(map.landBounds()), river.aspect));
    const [part, box] = [new Float32Array(framing), new Float32Array(title)];
    river.frame(part);
    return map.headedMasks(width, height, width / SEEN_WIDTH_PX, part, box);
  });
  river.takeAnnotation(masks);
  await painted(river, course);
}

function edges([left = 0, top = 0, right = 1, bottom = 1]: Float32Array): Edges {
  return [left, top, right, bottom];
}
