/** The tools: a second wasm module, for what most visitors never ask for. It is fetched when somebody does. */

import wasmUrl from "../../pkg-tools/riverseed_tools_bg.wasm?url";
import { named, PageError } from "./errors.ts";
import { limited, SCRIPT_MS } from "./time-limits.ts";
import { once, start } from "./wasm-module.ts";

export type { Traced } from "../../pkg-tools/riverseed_tools.js";

export type Tools = typeof import("../../pkg-tools/riverseed_tools.js");

/** From where it lies beside the script, unless its first caller knows better. */
export const loadTools: (url?: string) => Promise<Tools> = once((url = wasmUrl) =>
  start(url, async (compiled) => {
    const tools = await limited(SCRIPT_MS, "its script", () => import("../../pkg-tools/riverseed_tools.js"));
    await tools.default({ module_or_path: compiled });
    return tools;
  }).catch((thrown: unknown) => {
    const { code, message } = named(thrown);
    throw new PageError(
      "no-tools",
      `the part of Riverseed that does this did not arrive (${code}: ${message}). Check the connection and try again.`,
    );
  }),
);
