/** The page's engine: rivers and pictures, and besides, all that its controls ask for. */

import init, * as engine from "../../pkg-page/riverseed_page.js";
import wasmUrl from "../../pkg-page/riverseed_page_bg.wasm?url";
import type { Core } from "./wasm.ts";
import { once, start } from "./wasm-module.ts";

export type {
  Lines,
  Parameter,
  Preset,
  Reading,
  River as PageRiver,
} from "../../pkg-page/riverseed_page.js";

export type PageCore = Core<typeof engine>;

export const loadPage: () => Promise<PageCore> = once(() =>
  start(wasmUrl, async (compiled) => {
    const { memory } = await init({ module_or_path: compiled });
    return { engine, memory };
  }),
);
