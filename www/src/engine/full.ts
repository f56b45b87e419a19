/** The full engine: rivers and pictures, and besides, what a page's controls ask for, the writing of files and the digest. */

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

/** From where it lies beside the script, unless its first caller knows better, who is also told of the module when that is compiled. */
export const loadFull: (url?: string, compiled?: (module: WebAssembly.Module) => void) => Promise<FullCore> = once(
  (url = wasmUrl, compiled) =>
    start(url, (module) => {
      compiled?.(module);
      return linkFull(module);
    }),
);

/** From a module that somebody else has compiled. */
export async function linkFull(module: WebAssembly.Module): Promise<FullCore> {
  const { memory } = await init({ module_or_path: module });
  return { engine, memory };
}
