/** Paints a river for a file, with its labels and scenery. */

import type { SteerCore, SteeredRiver } from "../engine/steer.ts";
import { askMapForFile, type LoadTeller } from "../player/annotator.ts";
import { type Course, inSteps } from "./course.ts";

/** An engine, with the loader of the teller. */
export interface MakerCore extends SteerCore {
  readonly loadTeller: LoadTeller;
}

/** Paints a finished river, with its labels. */
export async function paint(river: SteeredRiver, core: MakerCore, course: Course): Promise<void> {
  if (river.wantsAnnotation()) {
    const means = { loadTeller: core.loadTeller, holdOn: () => {} };
    const { width, height } = river;
    river.takeAnnotation(await askMapForFile(river, means, (map) => map.masks(width, height, 1, new Float32Array())));
    await course.pause();
  }
  river.refine();
  await inSteps(
    course,
    () => river.paint(),
    () => river.painted,
  );
}
