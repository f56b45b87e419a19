/** Makes pictures and cards of a link. Each grows a river for itself. */

import type { SteeredRiver } from "../engine/steer.ts";
import { type Course, grow, partOf } from "./course.ts";
import { CARD, type CardOrder, changed, type PictureOrder } from "./order.ts";
import { type MakerCore, paint } from "./painting.ts";
import { riverPng } from "./river-png.ts";

/** The ends of growing and of painting, as shares of a file's course. */
const GROWN = 0.2;
const PAINTED = 0.7;

export async function pictureOf(order: PictureOrder | CardOrder, core: MakerCore, course: Course): Promise<Blob> {
  const river = new core.engine.River(order.kind === "card" ? cardLink(order.link) : order.link);
  try {
    await grow(river, partOf(course, 0, GROWN));
    if (order.kind === "card") river.resize(CARD.width, CARD.height);
    else river.resize(...sidesFor(river, order));
    await paint(river, core, partOf(course, GROWN, PAINTED));
    const isTransparent = order.kind === "picture" && order.isTransparent;
    if (isTransparent) river.cutOut();
    return await riverPng(river, core.memory, isTransparent ? "rgba" : "rgb", partOf(course, PAINTED, 1));
  } finally {
    river.free();
  }
}

function sidesFor(river: SteeredRiver, { longerSide }: PictureOrder): [width: number, height: number] {
  const [width = 0, height = 0] = river.sidesFor(longerSide);
  return [width, height];
}

/**
 * Returns the link of a card: the map with its title, in letters that can be read at a small size, and with few labels
 * if it has any.
 */
export function cardLink(link: string): string {
  const labels = new URLSearchParams(link).get("labels") ?? "none";
  return changed(link, {
    cartouche: "plain",
    "label-size": "1.6",
    labels: labels === "none" ? undefined : "few",
  });
}
