/** The engine that writes files and digests, fetched when somebody asks for one. */

import init, * as engine from "../../pkg-files/riverseed_files.js";
import wasmUrl from "../../pkg-files/riverseed_files_bg.wasm?url";
import type { Core } from "./wasm.ts";
import { once, start } from "./wasm-module.ts";

export type { River as FilesRiver } from "../../pkg-files/riverseed_files.js";

export type FilesCore = Core<typeof engine>;

/** From where it lies beside the script, unless its first caller knows better. */
export const loadFiles: (url?: string) => Promise<FilesCore> = once((url = wasmUrl) =>
  start(url, async (compiled) => {
    const { memory } = await init({ module_or_path: compiled });
    return { engine, memory };
  }),
);
