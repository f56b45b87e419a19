/** Loads the modules that most readers never need, when they are needed: those that write files and name rivers. */

import type { Charts } from "../../engine/charts.ts";
import { named, PageError } from "../../engine/errors.ts";
import type { FullCore } from "../../engine/full.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";

/** The wasm modules' names in the package. */
const FULL = "riverseed_full_bg.wasm";
const CHARTS = "riverseed_chart_bg.wasm";

/**
 * Loads the full engine. `wasmUrl` is the address of the lean engine if that is not beside the script; the full one is
 * beside it.
 */
export async function loadFull(wasmUrl: string | undefined): Promise<FullCore> {
  try {
    const full = await limited(SCRIPT_MS, "its script", () => import("../../engine/full.ts"));
    return await full.loadFull(beside(wasmUrl, FULL));
  } catch (thrown) {
    const { code, message } = named(thrown);
    throw new PageError(
      "no-files",
      `the part of Riverseed that does this did not arrive (${code}: ${message}). Check the connection and try again.`,
    );
  }
}

/** Loads the charts module, also from beside the lean engine. */
export async function loadCharts(wasmUrl: string | undefined): Promise<Charts> {
  const charts = await limited(SCRIPT_MS, "its script", () => import("../../engine/charts.ts"));
  return charts.loadCharts(beside(wasmUrl, CHARTS));
}

function beside(wasmUrl: string | undefined, name: string): string | undefined {
  return wasmUrl && new URL(name, wasmUrl).href;
}
