/**
 * The engine that takes a recipe to its pixels, without labels, woods and hills: all that an element loads to show a map
 * that has none of them. `label.ts` has them, and `whole.ts` has everything.
 */

import init, * as engine from "../../pkg-make/riverseed.js";
import wasmUrl from "../../pkg-make/riverseed_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export type Engine = Pick<typeof engine, "River" | "readLink">;

/** An engine with its memory. */
export interface Core<Loaded = Engine> {
  readonly engine: Loaded;
  readonly memory: WebAssembly.Memory;
}

/** Loads the engine, once, from `url` or else from beside the script. */
export const load: (url?: string, progress?: () => void) => Promise<Core> = once((url = wasmUrl, progress) =>
  start(
    url,
    async (compiled) => {
      const { memory } = await init({ module_or_path: compiled });
      return { engine, memory };
    },
    progress,
  ),
);
