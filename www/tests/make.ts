/** The engine in Node. */

import { readFileSync } from "node:fs";
import * as engine from "../pkg-make/riverseed.js";

const wasm = new URL("../pkg-make/riverseed_bg.wasm", import.meta.url);
const { memory } = engine.initSync({ module: readFileSync(wasm) });

export { engine, memory };
