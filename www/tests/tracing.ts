/** The tracing of pictures in Node. */

import { readFileSync } from "node:fs";
import { initSync } from "../pkg-trace/riverseed_trace.js";

initSync({ module: readFileSync(new URL("../pkg-trace/riverseed_trace_bg.wasm", import.meta.url)) });

export { outlineOf, traceImage } from "../pkg-trace/riverseed_trace.js";
