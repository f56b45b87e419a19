#!/usr/bin/env node
// Checks that the scripts keep to the browser floor. Prints every violation, and fails. (Biome's useBaseline checks the
// style
// sheets.)

import { readdirSync, readFileSync } from "node:fs";
import { membersOf, newerThanFloor } from "./newer.mjs";

/** The folders with our scripts. Those by wasm-bindgen check by themselves for features that browsers may lack. */
const FOLDERS = ["src", "public"];

const scripts = FOLDERS.flatMap(scriptsIn);
const engine = membersOf(read("pkg-engine/riverseed_engine.d.ts"), "dts");
const ours = new Set([...engine, ...scripts.flatMap((file) => membersOf(read(file)))]);

for (const file of scripts)
  for (const { line, name } of newerThanFloor(read(file), ours)) {
    console.error(`${file}:${line}: ${name} is newer than the browser floor (browserslist in package.json)`);
    process.exitCode = 1;
  }

function scriptsIn(folder) {
  const names = readdirSync(folder, { recursive: true });
  return names.filter((name) => /\.[jt]s$/.test(name)).map((name) => `${folder}/${name}`);
}

function read(file) {
  return readFileSync(file, "utf8");
}
