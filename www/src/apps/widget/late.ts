/** Loads, when they are needed, the modules that most readers never need: the teller for names, the writer for SVG. */

import type { Teller } from "../../engine/tell.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import type { Writer } from "../../engine/write.ts";

/** The modules' names in the package. */
const TELLER = "riverseed_tell_bg.wasm";
const WRITER = "riverseed_write_bg.wasm";

/** Loads the teller. `wasmUrl` is the address of the engine if that is not beside the script; the teller is beside it. */
export async function loadTeller(wasmUrl: string | undefined): Promise<Teller> {
  const tell = await limited(SCRIPT_MS, "its script", () => import("../../engine/tell.ts"));
  return tell.loadTeller(beside(wasmUrl, TELLER));
}

/** Loads the writer, as `loadTeller` does the teller. */
export async function loadWriter(wasmUrl: string | undefined): Promise<Writer> {
  const write = await limited(SCRIPT_MS, "its script", () => import("../../engine/write.ts"));
  return write.loadWriter(beside(wasmUrl, WRITER));
}

function beside(wasmUrl: string | undefined, name: string): string | undefined {
  return wasmUrl && new URL(name, wasmUrl).href;
}
