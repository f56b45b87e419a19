#!/usr/bin/env node
// Prints the compressed sizes of the built widget, in bytes of gzip, beside their limits.
//
//   node scripts/weigh-widget.mjs            only reports what is too large, since another compiler makes another
// module
//   node scripts/weigh-widget.mjs --strict   fails if something is too large

import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import * as engine from "../pkg-engine/riverseed_engine.js";

const FOLDER = new URL("../dist-widget/", import.meta.url);

/** The files that a page fetches for a first river: without labels, with a worker and without; and with labels. */
const EMBED = ["river-seed.js", "worker.js", "riverseed_bg.wasm"];
const EMBED_HERE = ["river-seed.js", "tag-page-backend.js", "riverseed_bg.wasm"];
const LABELLED = ["river-seed.js", "worker.js", "riverseed_label_bg.wasm"];

// The element: of its bytes, 6 finish rivers that the reader is past, 120 tell what only the larger engines can read, 220
// hold the poster, tell progress and seek, and 600 are the caption, the link to the maker, and the page's theme as it changes.
const LIMITS = [
  ["element and loader", ["river-seed.js"], 8_780],
  ["glue", withImports("core.js"), 4_200],
  ["whole embed", EMBED, 368_500],
  ["whole embed, without a worker", EMBED_HERE, 369_500],
  ["whole embed with labels", LABELLED, 565_500],
  ["whole embed with the letters that it carries", EMBED, 381_000, lettersOf("seed=kauri")],
  // The whole engine as text, for pages opened from disk, where nobody waits for a line.
  ["classic script", ["river-seed.classic.js"], 928_500],
];

for (const [what, files, limit, text = ""] of LIMITS) {
  const parts = [...files.map(read), text].map((part) => (part.length > 0 ? gzipSync(part, { level: 9 }).length : 0));
  const bytes = parts.reduce((sum, one) => sum + one);
  const isTooMuch = bytes > limit;
  console.log(`${what}: ${bytes} of ${limit} (${files.join(", ")})${isTooMuch ? " — TOO LARGE for `make check`" : ""}`);
  if (isTooMuch && process.argv[2] === "--strict") process.exitCode = 1;
}

/** Returns the letters that come with an embed of a link. */
function lettersOf(link) {
  engine.initSync({ module: readFileSync(new URL("../pkg-engine/riverseed_engine_bg.wasm", import.meta.url)) });
  const river = new engine.River(link);
  while (river.advance(1000));
  return river.lettersFor(link) ?? "";
}

function read(file) {
  return readFileSync(new URL(file, FOLDER));
}

/** Returns a script with all files that it fetches before it runs. */
function withImports(file, seen = new Set()) {
  seen.add(file);
  for (const [, other] of read(file)
    .toString()
    .matchAll(/(?:\bfrom|\bimport) ?["'`]\.\/([^"'`]+)["'`]/g)) {
    if (!seen.has(other)) withImports(other, seen);
  }
  return [...seen];
}
