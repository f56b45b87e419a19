#!/usr/bin/env node
// Prints the compressed sizes of the built widget, in bytes of gzip, beside their limits.
//
//   node scripts/weigh-widget.mjs            only reports what is too large, since another compiler makes another
// module
//   node scripts/weigh-widget.mjs --strict   fails if something is too large

import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const FOLDER = new URL("../dist-widget/", import.meta.url);

/** The files that a page fetches for a first river: with a worker, and without. */
const EMBED = ["river-seed.js", "worker.js", "riverseed_bg.wasm"];
const EMBED_HERE = ["river-seed.js", "tag-page-backend.js", "riverseed_bg.wasm"];

// The element was 6,000 bytes. Giving up workers that never answer, and replacing those that stop answering, took 600;
// the
// attributes of drainage and courses 60, those of labels and scenery 80, and the state that scripts can read 400. The
// embed was
// 170,000: styles with relief added 6,000, charts 6,000 more; without a worker, the renderer that the page shares added
// 500,
// and its drafts and rivers side by side another 500.
const LIMITS = [
  ["element and loader", ["river-seed.js"], 7_250],
  ["glue", withImports("core.js"), 5_000],
  ["whole embed", EMBED, 183_300],
  ["whole embed, without a worker", EMBED_HERE, 183_900],
];

for (const [what, files, limit] of LIMITS) {
  const bytes = files.map((file) => gzipSync(read(file), { level: 9 }).length).reduce((sum, one) => sum + one);
  const isTooMuch = bytes > limit;
  console.log(`${what}: ${bytes} of ${limit} (${files.join(", ")})${isTooMuch ? " — TOO LARGE for `make check`" : ""}`);
  if (isTooMuch && process.argv[2] === "--strict") process.exitCode = 1;
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
