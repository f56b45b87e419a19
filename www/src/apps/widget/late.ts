/** What most readers never need, and is fetched when somebody does: what writes files, and what names rivers. */

import type { Charts } from "../../engine/charts.ts";
import { named, PageError } from "../../engine/errors.ts";
import type { FullCore } from "../../engine/full.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";

/** The wasm modules, as the package has them. */
const FULL = "riverseed_full_bg.wasm";
const CHARTS = "riverseed_chart_bg.wasm";

/** The address is that of the lean engine, if it is not beside the script: the others lie beside it. */
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

/** The same of what makes charts. */
export async function loadCharts(wasmUrl: string | undefined): Promise<Charts> {
  const charts = await limited(SCRIPT_MS, "its script", () => import("../../engine/charts.ts"));
  return charts.loadCharts(beside(wasmUrl, CHARTS));
}

function beside(wasmUrl: string | undefined, name: string): string | undefined {
  return wasmUrl && new URL(name, wasmUrl).href;
}
