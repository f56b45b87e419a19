/** Paints a river for a file, with its labels and scenery. */

import type { SteerCore, SteeredRiver } from "../engine/steer.ts";
import type { LoadTeller } from "../player/asking.ts";
import { type Course, inSteps } from "./course.ts";
import { type Frame, labelled } from "./means.ts";

/** An engine, with the loader of the teller. */
export interface MakerCore extends SteerCore {
  readonly loadTeller: LoadTeller;
}

/** Paints a finished river, with its labels. `frame` is the picture's, if it does not show just the map. */
export async function paint(river: SteeredRiver, core: MakerCore, course: Course, frame?: Frame): Promise<void> {
  await labelled(river, { loadTeller: core.loadTeller, holdOn: () => {} }, frame);
  await painted(river, course);
}

/** Paints a finished river that has its labels. */
export async function painted(river: SteeredRiver, course: Course): Promise<void> {
  await course.pause();
  river.refine();
  await inSteps(
    course,
    () => river.paint(),
    () => river.painted,
  );
}
