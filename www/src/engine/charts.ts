/** Charts, what a map has besides its rivers: names, labels, woods and hills. A wasm module of its own, fetched when one is first wanted. */

import init, { Chart } from "../../pkg-chart/riverseed_chart.js";
import wasmUrl from "../../pkg-chart/riverseed_chart_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export interface Charts {
  readonly Chart: typeof Chart;
}

/** From where it lies beside the script, unless its first caller knows better. */
export const loadCharts: (url?: string) => Promise<Charts> = once((url = wasmUrl) =>
  start(url, async (compiled): Promise<Charts> => {
    await init({ module_or_path: compiled });
    return { Chart };
  }),
);
