/** The teller and the writer in Node. */

import { readFileSync } from "node:fs";
import { FinishedMap, initSync as initTeller } from "../pkg-tell/riverseed_tell.js";
import { digestWidth, initSync as initWriter, MapFiles } from "../pkg-write/riverseed_write.js";
import type { Teller } from "../src/engine/tell.ts";
import type { River } from "../src/engine/types.ts";
import type { Writer } from "../src/engine/write.ts";
import { askMap, writeMap } from "../src/player/asking.ts";

initTeller({ module: readFileSync(new URL("../pkg-tell/riverseed_tell_bg.wasm", import.meta.url)) });
initWriter({ module: readFileSync(new URL("../pkg-write/riverseed_write_bg.wasm", import.meta.url)) });

export const teller: Teller = { FinishedMap };
const writer: Writer = { MapFiles, digestWidth };

export const loadTeller = (): Promise<Teller> => Promise.resolve(teller);
export const loadWriter = (): Promise<Writer> => Promise.resolve(writer);

/** Asks the map of a finished river something. */
export function told<Said>(river: Pick<River, "mapData">, ask: (map: FinishedMap) => Said): Said {
  return askMap(river, teller, ask);
}

/** Has a file of the map of a finished river written. */
export function written<Written>(river: Pick<River, "mapData">, write: (map: MapFiles) => Written): Written {
  return writeMap(river, writer, write);
}
