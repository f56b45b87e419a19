#!/usr/bin/env node
// Packs the WordPress plugin, with the element in it: target/package/river-seed-wordpress.zip. The same files make the same bytes.
//
//   node integrations/wordpress/pack.mjs PACKAGE OUT.zip     PACKAGE is the npm package, unpacked

import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { argv } from "node:process";
import { fileURLToPath } from "node:url";
import { zipSync } from "fflate";
import { elementFiles } from "../river-seed.mjs";

const [folder, out] = argv.slice(2);
const PLUGIN = fileURLToPath(new URL("river-seed/", import.meta.url));
const PAPERS = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];

const element = await elementFiles(join(folder, "integrity.json"));
const files = [
  ...readdirSync(PLUGIN, { recursive: true })
    .filter((name) => statSync(join(PLUGIN, name)).isFile())
    .map((name) => [name, join(PLUGIN, name)]),
  ...PAPERS.map((name) => [name, join(folder, name)]),
  ...element.map((name) => [`element/${name}`, join(folder, name)]),
].sort(([one], [other]) => (one < other ? -1 : 1));

// A zip has no time zone, and no year before 1980.
const mtime = new Date(1980, 0, 1);
const packed = zipSync(Object.fromEntries(files.map(([name, path]) => [`river-seed/${name}`, readFileSync(path)])), {
  mtime,
  level: 9,
});
writeFileSync(out, packed);
console.log(`${out}: ${files.length} files, ${packed.length} bytes`);
