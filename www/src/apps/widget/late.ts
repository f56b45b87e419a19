/** Loads the teller, which most readers never need, when it is needed: for names, and for files with shapes. */

import type { Teller } from "../../engine/tell.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";

/** The teller's name in the package. */
const TELLER = "riverseed_tell_bg.wasm";

/** Loads the teller. `wasmUrl` is the address of the engine if that is not beside the script; the teller is beside it. */
export async function loadTeller(wasmUrl: string | undefined): Promise<Teller> {
  const tell = await limited(SCRIPT_MS, "its script", () => import("../../engine/tell.ts"));
  return tell.loadTeller(wasmUrl && new URL(TELLER, wasmUrl).href);
}
