/** Paints a river for a file, with its labels and scenery. */

import type { FullCore, FullRiver } from "../engine/full.ts";
import { askChartForFile, type LoadCharts } from "../player/chart-maker.ts";
import { type Course, inSteps } from "./course.ts";

/** An engine, with the loader of the charts module. */
export interface MakerCore extends FullCore {
  readonly loadCharts: LoadCharts;
}

/** Paints a finished river, with its chart. */
export async function paint(river: FullRiver, core: MakerCore, course: Course): Promise<void> {
  if (river.wantsChart()) {
    const means = { loadCharts: core.loadCharts, holdOn: () => {} };
    const { width, height } = river;
    river.takeChart(await askChartForFile(river, means, (chart) => chart.masks(width, height, 1, new Float32Array())));
    await course.pause();
  }
  await inSteps(
    course,
    () => river.paint(),
    () => river.painted,
  );
}
