/** Paints a river for a file. */

import type { WholeRiver } from "../engine/whole.ts";
import { type Course, inSteps } from "./course.ts";

/** Paints a finished river, as sharp as a file can be. */
export async function painted(river: WholeRiver, course: Course): Promise<void> {
  await course.pause();
  river.refine();
  await inSteps(
    course,
    () => river.paint(),
    () => river.painted,
  );
}
