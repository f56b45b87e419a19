/** The tools in Node, which files, traced pictures and digests take. */

import { readFileSync } from "node:fs";
import * as tools from "../pkg-tools/riverseed_tools.js";

tools.initSync({ module: readFileSync(new URL("../pkg-tools/riverseed_tools_bg.wasm", import.meta.url)) });

export { tools };
