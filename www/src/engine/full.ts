/**
 * The full engine: rivers and pictures, and also the data of the page's controls, the writing of files and the digest.
 */

import init, * as engine from "../../pkg-full/riverseed_full.js";
import wasmUrl from "../../pkg-full/riverseed_full_bg.wasm?url";
import type { Core } from "./wasm.ts";
import { once, start } from "./wasm-module.ts";

export type {
  Drafted,
  Inspector,
  Lines,
  Measure,
  Parameter,
  Preset,
  Reading,
  River as FullRiver,
  RiverFacts,
  Timeline,
} from "../../pkg-full/riverseed_full.js";

export type FullCore = Core<typeof engine>;

/**
 * Loads the engine, once, from `url` or else from beside the script. `compiled` is called with the module as soon as
 * that is compiled.
 */
export const loadFull: (url?: string, compiled?: (module: WebAssembly.Module) => void) => Promise<FullCore> = once(
  (url = wasmUrl, compiled) =>
    start(url, (module) => {
      compiled?.(module);
      return linkFull(module);
    }),
);

/** Starts the engine from a module that is compiled already. */
export async function linkFull(module: WebAssembly.Module): Promise<FullCore> {
  const { memory } = await init({ module_or_path: module });
  return { engine, memory };
}
