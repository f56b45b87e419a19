/** The worker's side of making one file. */

import { named } from "../../engine/errors.ts";
import { loadWhole, type WholeCore } from "../../engine/whole.ts";
import type { Course } from "../../files/course.ts";
import type { Order, Said } from "../../files/order.ts";

const say = (said: Said): void => self.postMessage(said);

/** A course that never pauses: nothing else runs in the worker, and a cancelled file ends with it. */
const course: Course = { tell: (share) => say({ is: "at", share }), pause: () => Promise.resolve() };

/** Makes the file that the first message orders. */
export function serve<Made extends Order>(make: (order: Made, core: WholeCore, course: Course) => Promise<Blob>): void {
  const answer = async (order: Made): Promise<void> => {
    try {
      say({ is: "made", file: await make(order, await loadWhole(), course) });
    } catch (thrown) {
      const { code, message } = named(thrown);
      say({ is: "failed", code, message });
    }
  };
  self.addEventListener("message", ({ data }: MessageEvent<Made>) => void answer(data), { once: true });
  say({ is: "open" });
}
