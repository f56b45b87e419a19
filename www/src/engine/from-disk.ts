/** The wasm modules that make files, for Node: read from disk, beside the script, when they are first needed. */

import { readFileSync } from "node:fs";
import { Chart, initSync as initChart } from "../../pkg-chart/riverseed_chart.js";
import chartUrl from "../../pkg-chart/riverseed_chart_bg.wasm?url";
import * as engine from "../../pkg-full/riverseed_full.js";
import fullUrl from "../../pkg-full/riverseed_full_bg.wasm?url";
import type { Charts } from "./charts.ts";

let isRead = false;

/** Returns the engine and the charts module. The first call blocks while they are compiled. */
export function fromDisk(): { readonly engine: typeof engine; readonly charts: Charts } {
  if (!isRead) {
    engine.initSync({ module: readFileSync(new URL(fullUrl)) });
    initChart({ module: readFileSync(new URL(chartUrl)) });
    isRead = true;
  }
  return { engine, charts: { Chart } };
}
