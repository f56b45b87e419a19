/** The engine that writes files, in Node. */

import { readFileSync } from "node:fs";
import * as files from "../pkg-files/riverseed_files.js";

const wasm = new URL("../pkg-files/riverseed_files_bg.wasm", import.meta.url);
const { memory } = files.initSync({ module: readFileSync(wasm) });

export { files, memory };
