/**
 * Charts: the names, labels, woods and hills of a map. They come from a separate wasm module, fetched when a chart is
 * first wanted.
 */

import init, { Chart } from "../../pkg-chart/riverseed_chart.js";
import wasmUrl from "../../pkg-chart/riverseed_chart_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export interface Charts {
  readonly Chart: typeof Chart;
}

/** Loads the charts module, once, from `url` or else from beside the script. */
export const loadCharts: (url?: string) => Promise<Charts> = once((url = wasmUrl) =>
  start(url, async (compiled): Promise<Charts> => {
    await init({ module_or_path: compiled });
    return { Chart };
  }),
);
