#!/usr/bin/env node
// Counts how doc comments open. A function's is a verb phrase ("Paints …"), not an article or a clause ("The …", "All …",
// "Where …"). Anything else's is a plain noun ("The finished map"), not a noun clause ("What …", "Whether …", "Of …").
//
//   node scripts/prose.mjs [FOLDER]   prints, for each module of this project or of FOLDER, its functions and all else that
//                                     have comments, and how many of them open otherwise; fails if they are more than LIMIT
//                                     in a module that is not of NOT_YET

import { readdirSync, readFileSync } from "node:fs";
import { extname, join, relative } from "node:path";
import { argv, exit } from "node:process";
import { fileURLToPath } from "node:url";

// Modules whose comments have not been rewritten. A module is a folder or a file without its extension.
const NOT_YET = [];
const LIMIT = 0.05;
const CLAUSE = /^(What|Whether|How|Of|The same|Those)\b/;
const NO_VERB = new RegExp(
  "^(The|An?|This|That|These|Those|Its?|Their|They|Our|Another|Other|Such|Each|Every|Both|All|Any|Some|Many|Most|One|Two|Three|No|None|" +
    "Nothing|Number|What|Whatever|Which|Whose|Whether|Who|How|However|Where|Wherever|When|While|Until|If|Since|Because|So|As|Of|In|Into|" +
    "On|At|By|For|From|To|Up|With|Without|Along|Beside|Near|Between|After|Before|Below|Above|About|Only|Half|Twice)\\b",
);

// Folders that are divided into modules, and folders that are one module each.
const DIVIDED = ["src", "www/src"];
const WHOLE = ["crates/cli", "crates/exchange", "crates/wasm", "python/src", "tests/common", "tests", "benches", "examples", "fuzz/fuzz_targets"];

// Lines that begin a function, a method or a callback; an accessor is read like a field.
const FUNCTION = {
  ".rs": /^(pub(\(.*?\))? |const |async |unsafe |extern "C" )*fn\b/,
  ".ts": /^(export |default |async )*function\b|^(export |const |static |async |readonly )*#?\w+\??(<.*?>)?(\(| = (async )?(<.*>)?\([^=]*=>|: \(.*\) =>)/,
};

// Folders where a function is a case, whose comment may tell it as a fact.
const CASES = /^(tests|benches|examples|fuzz)\b/;

const root = argv[2] ?? fileURLToPath(new URL("../", import.meta.url));
const counts = count();
const failing = [...counts].filter(([name, kinds]) => !NOT_YET.includes(name) && Object.values(kinds).some((kind) => share(kind) > LIMIT));
print();
for (const [module] of failing) console.error(`${module}: more than ${percent(LIMIT)} of its comments open otherwise`);
exit(failing.length > 0 ? 1 : 0);

function count() {
  const counts = new Map();
  for (const path of new Set([...DIVIDED, ...WHOLE].flatMap(sources))) {
    const module = moduleOf(path);
    const kinds = counts.get(module) ?? none();
    for (const { opening, isFunction } of commentsOf(readFileSync(join(root, path), "utf8"), extname(path))) {
      const kind = isFunction && !CASES.test(path) ? "functions" : "others";
      kinds[kind].comments++;
      if ((kind === "functions" ? NO_VERB : CLAUSE).test(opening)) kinds[kind].otherwise++;
    }
    counts.set(module, kinds);
  }
  return new Map([...counts].sort(([a], [b]) => (a < b ? -1 : 1)));
}

function none() {
  return { functions: { comments: 0, otherwise: 0 }, others: { comments: 0, otherwise: 0 } };
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

/**
 * Returns the first line of each doc comment (a run of `///` or `//!` in Rust, a block in TypeScript), and whether it is a
 * function's: the first line below attributes and other comments tells.
 */
function commentsOf(text, extension) {
  const comment =
    extension === ".rs"
      ? /^[ \t]*(\/\/[/!])(?!\/) ?(.*)(?:\n[ \t]*\1(?!\/).*)*(?:\s*#\[[^]*?\]$|\s*\/\/(?![/!]).*)*\n[ \t]*(.*)/gm
      : /(\/\*\*)\s+(?:\* )?(.*?)(?: ?\*\/|\n[^]*?\*\/)\s*(.*)/g;
  return [...text.matchAll(comment)].map(([, mark, opening, item]) => ({ opening, isFunction: mark !== "//!" && FUNCTION[extension].test(item) }));
}

function share({ comments, otherwise }) {
  return comments === 0 ? 0 : otherwise / comments;
}

function print() {
  const sums = { src: none(), all: none() };
  console.log("comments of          functions      others");
  for (const [module, kinds] of counts) {
    row(module, kinds);
    for (const sum of module.startsWith("src/") ? [sums.src, sums.all] : [sums.all]) add(sum, kinds);
  }
  row("src", sums.src);
  row("all", sums.all);
}

function add(sum, kinds) {
  for (const kind of ["functions", "others"]) {
    sum[kind].comments += kinds[kind].comments;
    sum[kind].otherwise += kinds[kind].otherwise;
  }
}

function row(name, { functions, others }) {
  const cell = (kind) => `${String(kind.comments).padStart(6)} ${percent(share(kind)).padStart(5)}`;
  console.log(`${name.padEnd(20)}${cell(functions)}${cell(others)}${NOT_YET.includes(name) ? "  not yet" : ""}`);
}

function percent(part) {
  return `${Math.round(100 * part)} %`;
}
