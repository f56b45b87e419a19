/** The full engine in Node: with files and digests. */

import { readFileSync } from "node:fs";
import * as full from "../pkg-full/riverseed_full.js";

const wasm = new URL("../pkg-full/riverseed_full_bg.wasm", import.meta.url);
const { memory } = full.initSync({ module: readFileSync(wasm) });

export { full, memory };
