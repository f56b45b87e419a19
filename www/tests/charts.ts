/** What makes charts, in Node. */

import { readFileSync } from "node:fs";
import { Chart, initSync } from "../pkg-chart/riverseed_chart.js";
import type { Charts } from "../src/engine/charts.ts";
import type { Chartable } from "../src/player/chart-maker.ts";

initSync({ module: readFileSync(new URL("../pkg-chart/riverseed_chart_bg.wasm", import.meta.url)) });

export const charts: Charts = { Chart };

export const loadCharts = (): Promise<Charts> => Promise.resolve(charts);

/** The names of a finished river's map, for its files. */
export function namesOf(river: Chartable): Uint32Array {
  const chart = new Chart(river.mapData());
  const names = chart.names();
  chart.free();
  return names;
}
