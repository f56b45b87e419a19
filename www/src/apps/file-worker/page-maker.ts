/** Makes files on the page itself, with the page's engine. */

import { loadWhole } from "../../engine/whole.ts";
import type { Course } from "../../files/course.ts";
import type { Order } from "../../files/order.ts";
import { pictureOf } from "../../files/picture.ts";

export async function makeHere(order: Order, course: Course): Promise<Blob> {
  const core = await loadWhole();
  if (order.kind !== "animation") return pictureOf(order, core, course);
  // The video writer is large, and most visitors never need it.
  const { animationOf } = await import("../../files/animation.ts");
  return animationOf(order.link, core, course);
}
