/**
 * The writer: files of shapes and numbers, and the digest, of a finished map. It is a separate wasm module, fetched
 * when somebody saves such a file, and gets the map from the engine.
 */

import init, { digestWidth, MapFiles } from "../../pkg-write/riverseed_write.js";
import wasmUrl from "../../pkg-write/riverseed_write_bg.wasm?url";
import { once, start } from "./wasm-module.ts";

export interface Writer {
  readonly MapFiles: typeof MapFiles;
  /** Returns the width and height, in pixels, of the picture that goes into a digest. */
  readonly digestWidth: typeof digestWidth;
}

/** Loads the writer, once, from `url` or else from beside the script. */
export const loadWriter: (url?: string) => Promise<Writer> = once((url = wasmUrl) =>
  start(url, async (compiled): Promise<Writer> => {
    await init({ module_or_path: compiled });
    return { MapFiles, digestWidth };
  }),
);
