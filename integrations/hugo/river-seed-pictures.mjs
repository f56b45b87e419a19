// Draws the pictures of all river-seed shortcodes into assets/riverseed, lists the maps in maps.json there, and copies the element's files
// to static/riverseed: Hugo runs no programs itself. Run it in the site's folder before `hugo`.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { copyElement, drawOnce, fileOf, RiverSeedError, readMap, refuseNested } from "./river-seed.mjs";

/** A parameter in one of Hugo's three spellings, with or without a name. */
const PARAMETER = /(?:([\w-]+)=)?(?:"((?:\\"|[^"\\]|\\(?!"))*)"|`([^`]*)`|([^\s"`>%=]+))/g;
const SHORTCODE = new RegExp(String.raw`\{\{[<%]\s*river-seed((?:\s+${PARAMETER.source})*)\s*\/?\s*[>%]\}\}`, "g");
/** Code in Markdown, where an element's tag is only text. */
const CODE = /^ *(`{3,}|~{3,})[^]*?^ *\1|`[^`\n]*`/gm;

const [content = "content", assets = "assets", statics = "static"] = process.argv.slice(2);

/** The facts about each map that the shortcode needs, by the hash of the text that names it. */
const maps = {};
try {
  for (const name of pagesOf(content)) await drawAll(join(content, name));
  await copyElement(join(statics, "riverseed"));
  if (Object.keys(maps).length > 0) writeFileSync(join(assets, "riverseed/maps.json"), JSON.stringify(maps, null, 2));
} catch (error) {
  tell(error);
}

function pagesOf(folder) {
  try {
    return readdirSync(folder, { recursive: true }).filter((name) => /\.(md|markdown|html)$/.test(name));
  } catch (error) {
    throw new RiverSeedError(
      `the content folder ${JSON.stringify(folder)} cannot be read (${error.code}). Run this in the site's folder, or name its folders: node river-seed-pictures.mjs content assets static`,
    );
  }
}

async function drawAll(file) {
  const text = readFileSync(file, "utf8");
  let line = 0;
  try {
    refuseNested(text.replace(SHORTCODE, "<river-seed></river-seed>").replace(CODE, ""));
    for (const { 1: parameters, index } of text.matchAll(SHORTCODE)) {
      line = text.slice(0, index).split("\n").length;
      await drawMap(mapOf(parameters));
    }
  } catch (error) {
    tell(error, `${file}${line ? `:${line}` : ""}: `);
  }
}

/** Returns the map among a shortcode's parameters: the one that is named so, or where none has a name the first. */
function mapOf(parameters) {
  const all = [...parameters.matchAll(PARAMETER)].map(([, name, quoted, raw, bare]) => ({
    name,
    value: quoted?.replaceAll('\\"', '"') ?? raw ?? bare,
  }));
  const isNamed = all.some(({ name }) => name);
  return all.find(({ name }) => !isNamed || name === "map")?.value;
}

async function drawMap(map) {
  const { link, alternative, isPictureAlone } = readMap(map);
  const folder = join(assets, "riverseed");
  await drawOnce(link, folder);
  maps[createHash("sha256").update(map).digest("hex")] = { link, alternative, picture: fileOf(link), isPictureAlone };
}

function tell(error, where = "") {
  if (!(error instanceof RiverSeedError)) throw error;
  console.error(`${where}${error.message}`);
  process.exitCode = 1;
}
