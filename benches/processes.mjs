// Fresh processes, each for one piece of work.

import { execFileSync, spawn } from "node:child_process";
import { readFileSync } from "node:fs";

/** Does a task as wasm in a process of its own. Returns the milliseconds that it spent on it, from when the module stood ready. */
export function coldly(task) {
  return Number(execFileSync(process.execPath, ["benches/cold.mjs", task], { encoding: "utf8" }));
}

/**
 * Runs a program to its end. Returns the milliseconds that it spent on processors and the most memory that it had, in MB; `null` where
 * the system does not tell.
 */
export function footprint(program, options) {
  return new Promise((done, failed) => {
    const child = spawn(program, options, { stdio: ["ignore", "ignore", "inherit"] });
    let found = null;
    // The system keeps the peak and the sum, until the process is gone: what its last milliseconds add is missed.
    const watch = setInterval(() => (found = footprintSoFar(child.pid) ?? found), 2);
    child.on("error", failed);
    child.on("exit", (code) => {
      clearInterval(watch);
      if (code === 0) done(found);
      else failed(new Error(`${program} failed`));
    });
  });
}

/** Returns what a process has taken until now; `null` once it is gone. */
function footprintSoFar(pid) {
  const TICK = 10; // ms, the unit of times in /proc
  try {
    const peak = /VmHWM:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, "utf8"));
    // User and system time of all its threads, counted after the name, which may have spaces.
    const [user, system] = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ").slice(11, 13);
    return peak && { ms: (Number(user) + Number(system)) * TICK, megabytes: (Number(peak[1]) * 1024) / 1e6 };
  } catch {
    return null;
  }
}
