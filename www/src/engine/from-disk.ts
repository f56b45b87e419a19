/** The wasm modules that make files, for Node: read from disk, beside the script, when they are first needed. */

import { readFileSync } from "node:fs";
import * as engine from "../../pkg-make/riverseed.js";
import makeUrl from "../../pkg-make/riverseed_bg.wasm?url";
import { digestWidth, FinishedMap, initSync as initTeller } from "../../pkg-tell/riverseed_tell.js";
import tellUrl from "../../pkg-tell/riverseed_tell_bg.wasm?url";
import type { Teller } from "./tell.ts";

let isRead = false;

/** Returns the engine and the teller. The first call blocks while they are compiled. */
export function fromDisk(): { readonly engine: typeof engine; readonly teller: Teller } {
  if (!isRead) {
    engine.initSync({ module: readFileSync(new URL(makeUrl)) });
    initTeller({ module: readFileSync(new URL(tellUrl)) });
    isRead = true;
  }
  return { engine, teller: { FinishedMap, digestWidth } };
}
