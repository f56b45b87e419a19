/** The engine for Node: read from disk, beside the script, when it is first needed. */

import { readFileSync } from "node:fs";
import * as whole from "../../pkg-engine/riverseed_engine.js";
import wasmUrl from "../../pkg-engine/riverseed_engine_bg.wasm?url";

let isRead = false;

/** Returns the engine. The first call blocks while it is compiled. */
export function engine(): typeof whole {
  if (!isRead) whole.initSync({ module: readFileSync(new URL(wasmUrl)) });
  isRead = true;
  return whole;
}
