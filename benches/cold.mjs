// Does a task once in this fresh process, as wasm, and prints the milliseconds that the process spent on it, from when the module
// stood ready: also those in which V8 compiles it.

import { wasmSide } from "./sides.mjs";

const side = wasmSide();
const before = process.cpuUsage();
await side.run(process.argv[2]);
const { user, system } = process.cpuUsage(before);
console.log((user + system) / 1000);
