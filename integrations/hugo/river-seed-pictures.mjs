// Draws the pictures of all river-seed shortcodes into assets/riverseed, and copies the element's files to static/riverseed: Hugo runs
// no programs itself. Run it in the site's folder before `hugo`.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { copyElement, drawOnce, RiverSeedError, refuseNested } from "./river-seed.mjs";

/** A shortcode with its first parameter in one of Hugo's three spellings. */
const SHORTCODE = /\{\{[<%]\s*river-seed\s+(?:"((?:\\"|[^"])*)"|`([^`]*)`|([^\s"`>%]+))[^{}]*?[>%]\}\}/g;

const [content = "content", assets = "assets", statics = "static"] = process.argv.slice(2);

await copyElement(join(statics, "riverseed"));
for (const name of readdirSync(content, { recursive: true }))
  if (/\.(md|markdown|html)$/.test(name)) await drawAll(join(content, name));

async function drawAll(file) {
  const text = readFileSync(file, "utf8");
  let line = 0;
  try {
    refuseNested(text.replace(SHORTCODE, "<river-seed></river-seed>"));
    for (const { 1: quoted, 2: raw, 3: bare, index } of text.matchAll(SHORTCODE)) {
      line = text.slice(0, index).split("\n").length;
      await drawOnce(quoted?.replaceAll('\\"', '"') ?? raw ?? bare, join(assets, "riverseed"));
    }
  } catch (error) {
    if (!(error instanceof RiverSeedError)) throw error;
    console.error(`${file}${line ? `:${line}` : ""}: ${error.message}`);
    process.exitCode = 1;
  }
}
