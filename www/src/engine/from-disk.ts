/** The wasm modules that make files, for Node: read from disk, beside the script, when each is first needed. */

import { readFileSync } from "node:fs";
import * as make from "../../pkg-make/riverseed.js";
import makeUrl from "../../pkg-make/riverseed_bg.wasm?url";
import { FinishedMap, initSync as initTeller } from "../../pkg-tell/riverseed_tell.js";
import tellUrl from "../../pkg-tell/riverseed_tell_bg.wasm?url";
import { digestWidth, initSync as initWriter, MapFiles } from "../../pkg-write/riverseed_write.js";
import writeUrl from "../../pkg-write/riverseed_write_bg.wasm?url";
import type { Teller } from "./tell.ts";
import type { Writer } from "./write.ts";

/** Returns the engine. The first call blocks while it is compiled, as with the others. */
export const engine = fromDisk(makeUrl, make.initSync, make);
/** Returns the teller. */
export const teller = fromDisk<Teller>(tellUrl, initTeller, { FinishedMap });
/** Returns the writer. */
export const writer = fromDisk<Writer>(writeUrl, initWriter, { MapFiles, digestWidth });

function fromDisk<Module>(url: string, init: (options: { module: BufferSource }) => unknown, module: Module) {
  let isRead = false;
  return (): Module => {
    if (!isRead) init({ module: readFileSync(new URL(url)) });
    isRead = true;
    return module;
  };
}
