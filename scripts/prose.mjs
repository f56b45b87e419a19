#!/usr/bin/env node
// Counts how doc comments begin. A public item's first line should be a verb phrase ("Paints …") or a plain noun ("The
// finished map"), not a noun clause ("What …", "Whether …", "Of …").
//
//   node scripts/prose.mjs [FOLDER]   prints, for each module of this project or of FOLDER, its doc comments and how many
//                                     open so; fails if a module of DONE has more than LIMIT of them

import { readdirSync, readFileSync } from "node:fs";
import { extname, join, relative } from "node:path";
import { argv, exit } from "node:process";
import { fileURLToPath } from "node:url";

// Modules whose comments have been rewritten. A module is a folder or a file without its extension.
const DONE = [
  "benches",
  "crates/cli",
  "crates/exchange",
  "crates/wasm",
  "examples",
  "fuzz/fuzz_targets",
  "python/src",
  "src/analyse",
  "src/base",
  "src/digest",
  "src/domain",
  "src/export",
  "src/grow",
  "src/import",
  "src/land",
  "src/lib",
  "src/map",
  "src/paint",
  "src/picture",
  "src/prune",
  "src/recipe",
  "src/session",
  "src/tree",
  "tests",
  "tests/common",
  "www/src/apps",
  "www/src/browser",
  "www/src/controls",
  "www/src/engine",
  "www/src/files",
  "www/src/host",
  "www/src/player",
];
const LIMIT = 0.05;
const STILTED = /^(What|Whether|How|Of|The same|Those)\b/;

// Folders that are divided into modules, and folders that are one module each.
const DIVIDED = ["src", "www/src"];
const WHOLE = ["crates/cli", "crates/exchange", "crates/wasm", "python/src", "tests/common", "tests", "benches", "examples", "fuzz/fuzz_targets"];

const root = argv[2] ?? fileURLToPath(new URL("../", import.meta.url));
const counts = count();
const failing = DONE.filter((module) => share(counts.get(module)) > LIMIT);
print();
for (const module of failing) console.error(`${module}: more than ${percent(LIMIT)} of its doc comments open so`);
exit(failing.length > 0 ? 1 : 0);

function count() {
  const counts = new Map();
  for (const path of new Set([...DIVIDED, ...WHOLE].flatMap(sources))) {
    const module = moduleOf(path);
    const sum = counts.get(module) ?? { comments: 0, stilted: 0 };
    const openings = openingsOf(readFileSync(join(root, path), "utf8"), extname(path));
    sum.comments += openings.length;
    sum.stilted += openings.filter((opening) => STILTED.test(opening)).length;
    counts.set(module, sum);
  }
  return new Map([...counts].sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** The source files in a folder and all folders in it; none if there is no such folder. */
function sources(folder) {
  return entries(folder, { recursive: true })
    .filter((entry) => entry.isFile() && [".rs", ".ts"].includes(extname(entry.name)))
    .map((entry) => relative(root, join(entry.parentPath, entry.name)));
}

function entries(folder, options) {
  try {
    return readdirSync(join(root, folder), { withFileTypes: true, ...options });
  } catch (error) {
    if (error.code === "ENOENT") return [];
    throw error;
  }
}

/** `src/land` for `src/land.rs` and for all files in `src/land/`; `tests` but those of `tests/common`, for each file in it. */
function moduleOf(path) {
  const whole = WHOLE.find((folder) => path.startsWith(`${folder}/`));
  const [source, rest] = path.split(/(?<=(?:^|\/)src)\//);
  return whole ?? `${source}/${rest.split("/")[0].replace(/\.(rs|ts)$/, "")}`;
}

/** The first line of each doc comment: a run of `///` or `//!` in Rust, a block in TypeScript. */
function openingsOf(text, extension) {
  const comment = extension === ".rs" ? /^[ \t]*(\/\/[/!])(?!\/) ?(.*)(?:\n[ \t]*\1(?!\/).*)*/gm : /()\/\*\*\s+(?:\* )?(.*)/g;
  return [...text.matchAll(comment)].map(([, , opening]) => opening);
}

function share({ comments, stilted } = { comments: 0, stilted: 0 }) {
  return comments === 0 ? 0 : stilted / comments;
}

function print() {
  const sum = { comments: 0, stilted: 0 };
  for (const [module, { comments, stilted }] of counts) {
    if (comments > 0) row(module, { comments, stilted });
    sum.comments += comments;
    sum.stilted += stilted;
  }
  row("all", sum);
}

function row(name, sum) {
  const note = DONE.includes(name) ? "  done" : "";
  console.log(`${name.padEnd(28)}${String(sum.comments).padStart(5)} ${percent(share(sum)).padStart(5)}${note}`);
}

function percent(part) {
  return `${Math.round(100 * part)} %`;
}
