/**
 * The engine that takes a recipe to its pixels: all that page and element load before they show a map. What tells about
 * a finished map is in `tell.ts`.
 */

import init, * as engine from "../../pkg-make/riverseed.js";
import wasmUrl from "../../pkg-make/riverseed_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export type Engine = typeof engine;

/** An engine with its memory. */
export interface Core {
  readonly engine: Engine;
  readonly memory: WebAssembly.Memory;
}

export interface LoadEvents {
  /** Called for every part of the module that arrives. */
  progress?(): void;
  /** Called with the module as soon as it is compiled. */
  compiled?(module: WebAssembly.Module): void;
}

/** Loads the engine, once, from `url` or else from beside the script. */
export const load: (url?: string, events?: LoadEvents) => Promise<Core> = once((url = wasmUrl, events) =>
  start(
    url,
    (module) => {
      events?.compiled?.(module);
      return linked(module);
    },
    events?.progress,
  ),
);

/** Starts the engine from a module that is compiled already. */
export async function linked(module: WebAssembly.Module): Promise<Core> {
  const { memory } = await init({ module_or_path: module });
  return { engine, memory };
}
