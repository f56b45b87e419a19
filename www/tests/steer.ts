/** The page's engine in Node: that of the element has no other rivers. */

import { readFileSync } from "node:fs";
import * as engine from "../pkg-steer/riverseed_steer.js";

const wasm = new URL("../pkg-steer/riverseed_steer_bg.wasm", import.meta.url);
const { memory } = engine.initSync({ module: readFileSync(wasm) });

export { engine, memory };
