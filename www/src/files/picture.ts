/** Makes pictures and cards of a link. Each grows a river for itself. */

import type { SteeredRiver } from "../engine/steer.ts";
import { cardLink, paintCard } from "./card.ts";
import { type Course, grow, partOf } from "./course.ts";
import type { CardOrder, PictureOrder } from "./order.ts";
import { type MakerCore, paint } from "./painting.ts";
import { riverPng } from "./river-png.ts";

/** The ends of growing and of painting, as shares of a file's course. */
const GROWN = 0.2;
const PAINTED = 0.7;

export async function pictureOf(order: PictureOrder | CardOrder, core: MakerCore, course: Course): Promise<Blob> {
  const river = new core.engine.River(order.kind === "picture" ? order.link : cardLink(order.link));
  try {
    await grow(river, partOf(course, 0, GROWN));
    const painting = partOf(course, GROWN, PAINTED);
    if (order.kind === "picture") await paintWhole(order, river, core, painting);
    else await paintCard(order.kind, river, core, painting);
    const isTransparent = order.kind === "picture" && order.isTransparent;
    if (isTransparent) river.cutOut();
    return await riverPng(river, core.memory, isTransparent ? "rgba" : "rgb", partOf(course, PAINTED, 1));
  } finally {
    river.free();
  }
}

async function paintWhole(order: PictureOrder, river: SteeredRiver, core: MakerCore, course: Course): Promise<void> {
  const [width = 0, height = 0] = river.sidesFor(order.longerSide);
  river.resize(width, height);
  await paint(river, core, course);
}
