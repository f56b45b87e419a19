/** The page's engine: as `make.ts`, with what people steer a map by while it grows and after. */

import init, * as engine from "../../pkg-steer/riverseed_steer.js";
import wasmUrl from "../../pkg-steer/riverseed_steer_bg.wasm?url";
import type { Core } from "./make.ts";
import { once, start } from "./wasm-module.ts";

export type { Drafted, Lines, River as SteeredRiver, Timeline } from "../../pkg-steer/riverseed_steer.js";

export type SteerCore = Core<typeof engine>;

/**
 * Loads the engine, once, from `url` or else from beside the script. `compiled` is called with the module as soon as
 * that is compiled.
 */
export const loadSteer: (url?: string, compiled?: (module: WebAssembly.Module) => void) => Promise<SteerCore> = once(
  (url = wasmUrl, compiled) =>
    start(url, (module) => {
      compiled?.(module);
      return linked(module);
    }),
);

/** Starts the engine from a module that is compiled already. */
export async function linked(module: WebAssembly.Module): Promise<SteerCore> {
  const { memory } = await init({ module_or_path: module });
  return { engine, memory };
}
