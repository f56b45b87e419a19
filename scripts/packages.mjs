#!/usr/bin/env node
// Whether www/node_modules holds what www/package-lock.json names.
//
//   node scripts/packages.mjs           prints "whole", "foreign" (made on another system, or for another Node.js) or "stale"
//   node scripts/packages.mjs missing   prints what is not there
//   node scripts/packages.mjs stamp     notes that npm has just installed them, here

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { arch, platform, versions } from "node:process";

const FOLDER = new URL("../www/", import.meta.url);
const STAMP = new URL("node_modules/.installed.json", FOLDER);

const text = readFileSync(new URL("package-lock.json", FOLDER), "utf8");
// File times say nothing in a fresh clone.
const lock = createHash("sha256").update(text).digest("hex");
// Some packages are native programs.
const system = `${platform} ${arch} node ${versions.node.split(".")[0]}`;

switch (process.argv[2]) {
  case "stamp":
    stamp();
    break;
  case "missing":
    console.log(missing().join("\n"));
    break;
  default:
    console.log(state());
}

function state() {
  const found = read(STAMP);
  if (found !== undefined && found.system !== system) return "foreign";
  return found?.lock === lock && missing().length === 0 ? "whole" : "stale";
}

/** The packages that are not there in their version. Those that only some systems need may be missing. */
function missing() {
  return Object.entries(JSON.parse(text).packages)
    .filter(([path, one]) => path !== "" && !one.optional && !one.devOptional && !one.peer)
    .filter(([path, one]) => read(new URL(`${path}/package.json`, FOLDER))?.version !== one.version)
    .map(([path, one]) => `${path} ${one.version}`);
}

function read(file) {
  try {
    return JSON.parse(readFileSync(file, "utf8"));
  } catch {
    return undefined;
  }
}

/** A new file: the folder may be a copy whose files are shared with the first. */
function stamp() {
  const fresh = new URL(".installed.json.new", STAMP);
  mkdirSync(new URL(".", STAMP), { recursive: true });
  writeFileSync(fresh, JSON.stringify({ lock, system }));
  renameSync(fresh, STAMP);
}
