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
    const dpi = order.kind === "picture" ? order.dpi : undefined;
    return await riverPng(river, core.memory, isTransparent ? "rgba" : "rgb", partOf(course, PAINTED, 1), dpi);
  } finally {
    river.free();
  }
}

/** Paints all of a map, on a sheet of paper if the order has one. */
async function paintWhole(order: PictureOrder, river: SteeredRiver, core: MakerCore, course: Course): Promise<void> {
  shape(river, order);
  await paint(river, core, course);
}

/** Gives a river's picture its size and shape. */
function shape(river: SteeredRiver, { longerSide, shorterSide }: PictureOrder): void {
  const [mapWidth = 1, mapHeight = 1] = river.lengths();
  if (shorterSide === undefined) {
    const [width = 0, height = 0] = river.sidesFor(longerSide);
    river.resize(width, height);
    return;
  }
  const [width, height] = mapWidth < mapHeight ? [shorterSide, longerSide] : [longerSide, shorterSide];
  river.resize(width, height);
  river.frame(centred(width, height, mapWidth / mapHeight));
}

/** Returns the framing of a picture with the whole map in its middle, as large as it can be: `River.frame`. */
export function centred(width: number, height: number, aspect: number): Float32Array {
  const across = Math.max(1, width / (height * aspect));
  const down = (across * height) / width;
  return Float32Array.of((1 - across) / 2, (1 / aspect - down) / 2, across);
}
