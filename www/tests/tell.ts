/** The teller in Node. */

import { readFileSync } from "node:fs";
import { digestWidth, FinishedMap, initSync } from "../pkg-tell/riverseed_tell.js";
import type { Teller } from "../src/engine/tell.ts";
import type { River } from "../src/engine/types.ts";
import { askMap } from "../src/player/annotator.ts";

initSync({ module: readFileSync(new URL("../pkg-tell/riverseed_tell_bg.wasm", import.meta.url)) });

export const teller: Teller = { FinishedMap, digestWidth };

export const loadTeller = (): Promise<Teller> => Promise.resolve(teller);

/** Asks the map of a finished river something. */
export function told<Said>(river: Pick<River, "mapData">, ask: (map: FinishedMap) => Said): Said {
  return askMap(river, teller, ask);
}
