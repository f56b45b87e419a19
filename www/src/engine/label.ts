/** The engine that takes any recipe to its pixels, with labels, woods and hills. */

import init, * as engine from "../../pkg-label/riverseed_label.js";
import wasmUrl from "../../pkg-label/riverseed_label_bg.wasm?url";
import type { Core } from "./make.ts";
import { once, start } from "./wasm-module.ts";

/** Loads the engine, once, from `url` or else from beside the script. */
export const loadLabel: (url?: string, progress?: () => void) => Promise<Core> = once((url = wasmUrl, progress) =>
  start(
    url,
    async (compiled) => {
      const { memory } = await init({ module_or_path: compiled });
      return { engine, memory };
    },
    progress,
  ),
);
