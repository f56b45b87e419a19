/** The lean engine: rivers and their pictures, which is all that a widget loads to show them. */

import init, * as engine from "../../pkg/riverseed.js";
import wasmUrl from "../../pkg/riverseed_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export type Engine = typeof engine;

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
