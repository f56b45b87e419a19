// The two sides that do the tasks of workload.rs. Each has `run(task)`, which returns { ms, result }.

import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

/** Starts the native program; cargo brings it up to date first. */
export async function nativeSide() {
  const child = spawn("cargo", ["bench", "--quiet", "--features", "json,png", "--bench", "figures"], {
    stdio: ["pipe", "pipe", "inherit"],
    // wasm memory is never given back to the system, so a repetition finds it there. Nor is it here: the time is
    // that of our work, not that of the kernel clearing pages.
    env: { ...process.env, GLIBC_TUNABLES: "glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=4000000000" },
  });
  const lines = createInterface(child.stdout)[Symbol.asyncIterator]();
  const answer = async () => Number((await lines.next()).value);
  const spent = processorTime(await answer());
  return {
    name: "native",
    async run(task) {
      const before = spent();
      child.stdin.write(`${task}\n`);
      const result = await answer();
      // Not a number: no such task, or the program is gone.
      if (Number.isNaN(result)) throw new Error(`the native program does not do '${task}'`);
      return { ms: spent() - before, result };
    },
    close: () => child.stdin.end(),
  };
}

/** Makes a clock of the milliseconds that another process, which is waiting for us, has spent on a processor. */
function processorTime(pid) {
  const file = `/proc/${pid}/schedstat`; // its first number, in ns
  if (!existsSync(file)) return () => performance.now();
  return () => Number(readFileSync(file, "utf8").split(" ")[0]) / 1e6;
}

/** Makes a fresh instance of the wasm module. */
export function wasmSide() {
  const require = createRequire(import.meta.url);
  const path = require.resolve("../target/figures-wasm/figures_wasm.js");
  delete require.cache[path];
  const figures = new (require(path).Figures)();
  return {
    name: "wasm",
    async run(task) {
      if (!figures.prepare(task)) throw new Error(`the wasm module does not do '${task}'`);
      const before = process.cpuUsage();
      const result = figures.run(task);
      const { user, system } = process.cpuUsage(before);
      return { ms: (user + system) / 1000, result };
    },
    memory: () => figures.memory(),
  };
}
