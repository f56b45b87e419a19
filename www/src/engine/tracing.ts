/**
 * Outlines of land from pictures and from drawn lines: a separate wasm module, fetched when somebody opens a picture or
 * draws.
 */

import init, { longestTracedSide, outlineOf, type Traced, traceImage } from "../../pkg-trace/riverseed_trace.js";
import wasmUrl from "../../pkg-trace/riverseed_trace_bg.wasm?url";
import { missing } from "./errors.ts";
import { once, start } from "./wasm-module.ts";

export type { Traced } from "../../pkg-trace/riverseed_trace.js";

export interface Tracing {
  readonly longestTracedSide: () => number;
  /** Makes an outline from lines of any length. Throws an error with the code "no-land" if they enclose no land. */
  readonly outlineOf: (coasts: Float32Array[], ridges: Float32Array[], rivers: Float32Array[]) => string;
  readonly traceImage: (rgba: Uint8Array, width: number, height: number) => Traced;
}

const load = once(() =>
  start(wasmUrl, async (compiled): Promise<Tracing> => {
    await init({ module_or_path: compiled });
    return { longestTracedSide, outlineOf, traceImage };
  }),
);

/**
 * Loads the tracing module. A failure gets the code "no-tracing", from which the page recovers, since the map is not
 * affected.
 */
export async function loadTracing(): Promise<Tracing> {
  try {
    return await load();
  } catch (error) {
    throw missing("no-tracing", "The part that turns drawings and pictures into land", error);
  }
}
