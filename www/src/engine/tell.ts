/**
 * The teller: names, labels, woods and hills of a finished map, its measures, and what lies at a place of it. It is a
 * separate wasm module, fetched when one of these is first wanted, and gets the map from the engine.
 */

import init, { FinishedMap } from "../../pkg-tell/riverseed_tell.js";
import wasmUrl from "../../pkg-tell/riverseed_tell_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export interface Teller {
  readonly FinishedMap: typeof FinishedMap;
}

/** Loads the teller, once, from `url` or else from beside the script. */
export const loadTeller: (url?: string) => Promise<Teller> = once((url = wasmUrl) =>
  start(url, async (compiled): Promise<Teller> => {
    await init({ module_or_path: compiled });
    return { FinishedMap };
  }),
);
