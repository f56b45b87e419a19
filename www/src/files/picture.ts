/** Makes pictures and cards of a link. Each grows a river for itself. */

import type { WholeCore, WholeRiver } from "../engine/whole.ts";
import { cardLink, composeCard } from "./card.ts";
import { type Course, grow, partOf } from "./course.ts";
import type { CardOrder, PictureOrder } from "./order.ts";
import { painted } from "./painting.ts";
import { riverPng } from "./river-png.ts";

/** The ends of growing and of painting, as shares of a file's course. */
const GROWN = 0.2;
const PAINTED = 0.7;

export async function pictureOf(order: PictureOrder | CardOrder, core: WholeCore, course: Course): Promise<Blob> {
  const river = new core.engine.River(order.kind === "picture" ? order.link : cardLink(order.link));
  try {
    await grow(river, partOf(course, 0, GROWN));
    const painting = partOf(course, GROWN, PAINTED);
    if (order.kind === "picture") shape(river, order);
    else composeCard(order.kind, river);
    await painted(river, painting);
    const isTransparent = order.kind === "picture" && order.isTransparent;
    if (isTransparent) river.cutOut();
    const dpi = order.kind === "picture" ? order.dpi : undefined;
    return await riverPng(river, core.memory, isTransparent ? "rgba" : "rgb", partOf(course, PAINTED, 1), dpi);
  } finally {
    river.free();
  }
}

/** Gives a river's picture its size and shape: those of the map, or of a sheet of paper if the order has one. */
function shape(river: WholeRiver, { longerSide, shorterSide }: PictureOrder): void {
  if (shorterSide === undefined) {
    const [width = 0, height = 0] = river.sidesFor(longerSide);
    river.resize(width, height);
    return;
  }
  // A sheet lies or stands as the map does.
  const map = river.lengths();
  const [width, height] = map.width < map.height ? [shorterSide, longerSide] : [longerSide, shorterSide];
  river.resize(width, height);
  river.frame(centred(width, height, map.width / map.height));
}

/** Returns the frame of a picture with the whole map in its middle, as large as it can be, as `River.frame` takes it. */
function centred(width: number, height: number, aspect: number): Float32Array {
  const across = Math.max(1, width / (height * aspect));
  const down = (across * height) / width;
  return Float32Array.of((1 - across) / 2, (1 / aspect - down) / 2, across);
}
