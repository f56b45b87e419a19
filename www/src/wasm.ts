/** The river engine: the wasm module that the page opens with. */

import init, * as engine from "../pkg/riverseed.js";
import wasmUrl from "../pkg/riverseed_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export type Engine = typeof engine;

export interface Core {
  readonly engine: Engine;
  readonly memory: WebAssembly.Memory;
}

export const load: () => Promise<Core> = once(() =>
  start(wasmUrl, async (compiled) => {
    const { memory } = await init({ module_or_path: compiled });
    return { engine, memory };
  }),
);
