/**
 * The whole engine: what `label.ts` has, what people steer a map by while it grows, what is asked of a finished map, and
 * its files.
 */

import init, * as engine from "../../pkg-engine/riverseed_engine.js";
import wasmUrl from "../../pkg-engine/riverseed_engine_bg.wasm?url";
import type { Core } from "./make.ts";
import { once, start } from "./wasm-module.ts";

export type { Drafted, Lines, River as WholeRiver, Timeline, Traced } from "../../pkg-engine/riverseed_engine.js";

export type WholeCore = Core<typeof engine>;

/**
 * Loads the engine, once, from `url` or else from beside the script. `compiled` is called with the module as soon as
 * that is compiled.
 */
export const loadWhole: (url?: string, compiled?: (module: WebAssembly.Module) => void) => Promise<WholeCore> = once(
  (url = wasmUrl, compiled) =>
    start(url, (module) => {
      compiled?.(module);
      return linked(module);
    }),
);

/** Starts the engine from a module that is compiled already. */
export async function linked(module: WebAssembly.Module): Promise<WholeCore> {
  const { memory } = await init({ module_or_path: module });
  return { engine, memory };
}
