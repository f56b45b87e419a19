/** The whole engine in Node. */

import { readFileSync } from "node:fs";
import * as engine from "../pkg-engine/riverseed_engine.js";

const wasm = new URL("../pkg-engine/riverseed_engine_bg.wasm", import.meta.url);
const { memory } = engine.initSync({ module: readFileSync(wasm) });

export { engine, memory };
