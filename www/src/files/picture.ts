/** Makes pictures and cards of a link. Each grows a river for itself. */

import type { SteeredRiver } from "../engine/steer.ts";
import { cardLink, paintCard } from "./card.ts";
import { type Course, grow, partOf } from "./course.ts";
import type { Frame } from "./means.ts";
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
  const frame = shape(river, order);
  await paint(river, core, course, frame);
}

/** Gives a river's picture its size and shape. Returns its frame if it does not show just the map. */
function shape(river: SteeredRiver, { longerSide, shorterSide }: PictureOrder): Frame | undefined {
  if (shorterSide === undefined) {
    const [width = 0, height = 0] = river.sidesFor(longerSide);
    river.resize(width, height);
    return;
  }
  return shapeSheet(river, longerSide, shorterSide);
}

/** Gives a river's picture the size of a sheet, which lies or stands as the map does. */
function shapeSheet(river: SteeredRiver, longerSide: number, shorterSide: number): Frame {
  const [mapWidth = 1, mapHeight = 1] = river.lengths();
  const [width, height] = mapWidth < mapHeight ? [shorterSide, longerSide] : [longerSide, shorterSide];
  const frame = centred(width, height, mapWidth / mapHeight);
  river.resize(width, height);
  river.frame([...frame]);
  return frame;
}

/** Returns the frame of a picture with the whole map in its middle, as large as it can be. */
function centred(width: number, height: number, aspect: number): Frame {
  const across = Math.max(1, width / (height * aspect));
  const down = (across * height) / width;
  return [(1 - across) / 2, (1 / aspect - down) / 2, across];
}
