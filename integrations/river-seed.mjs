// Makes what a page needs to show `<river-seed>`: the picture that readers without JavaScript see, drawn while the site is
// built, and the element's files. Eleventy, Astro, MDX, Hugo and the card share this file; copy it beside theirs.
//
// It takes `npm install riverseed sharp`.

import { createHash } from "node:crypto";
import { copyFile, mkdir, readFile, rename, stat } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { grow, PageError } from "riverseed/node";
import sharp from "sharp";

/** The picture's width in pixels: sharp in a column of 600 CSS pixels on screens of two pixels to each. */
const WIDTH = 1200;
/** The quality of WebP at which the edges of rivers are still clean: 100 kB a map, where PNG has 850. */
const QUALITY = 80;
/** Files of the package that no page with the element loads. */
const UNUSED = new Set(["river-seed.classic.js", "node.js"]);

/** Reports what a page asks for and cannot have. The message says what; the generator says on which page. */
export class RiverSeedError extends Error {
  name = "RiverSeedError";

  constructor(message) {
    super(`river-seed: ${message}`);
  }
}

/** Returns true for a map that is named by a link, such as `seed=kauri&land=valley`, and not by a word. */
export function isLink(map) {
  return /^\??[a-z][a-z-]*=/.test(map);
}

/** Returns the name of a map's picture, a hash: words may be any text, also `../`. */
export function fileOf(map) {
  return `river-seed-${createHash("sha256").update(map).digest("hex").slice(0, 16)}.webp`;
}

/**
 * Draws a map into a folder, unless its picture is there, and returns the attributes of the element and of the picture.
 * `base` is the address of the folder, and `alt` a text alternative of the author's own.
 */
export async function embed(map, { folder, base, alt }) {
  const { width, height } = await drawOnce(map, folder);
  const seed = isLink(map) ? (new URLSearchParams(map).get("seed") ?? "kauri") : map;
  return {
    script: `${base}river-seed.js`,
    element: { [isLink(map) ? "recipe" : "seed"]: map, ...(alt && { alt }), style: "display:block" },
    picture: {
      src: base + fileOf(map),
      alt: alt || `Rivers grown from “${seed}”`,
      width,
      height,
      style: "display:block;width:100%;height:auto",
    },
  };
}

/** Writes an embed as HTML. */
export function html({ script, element, picture }) {
  return `<script type="module" src="${escaped(script)}"></script><river-seed${attributes(element)}><img${attributes(picture)}></river-seed>`;
}

/** Copies the element's files from the npm package into a folder. */
export async function copyElement(folder) {
  const list = fileURLToPath(import.meta.resolve("riverseed/integrity.json"));
  const files = Object.keys(JSON.parse(await readFile(list, "utf8"))).filter((file) => !UNUSED.has(file));
  await mkdir(folder, { recursive: true });
  for (const file of files) await copyFile(join(dirname(list), file), join(folder, file));
}

/** Returns the address of the element's folder in a site whose own address or path is `site`. */
export function baseOf(site) {
  if (!/^(https?:\/\/[^/]|\.?\/(?!\/))/.test(site))
    throw new RiverSeedError(
      `the site's base is a path such as "/", "/blog/" or "./", or a whole address, not ${JSON.stringify(site)}`,
    );
  return `${site.replace(/\/*$/, "/")}riverseed/`;
}

/** Refuses a generator that is older than what this was tested with. */
export function needs(generator, least, version) {
  const parts = (text) => text.replace(/^\D*/, "").split(".").map(Number);
  const [[major, minor = 0], [leastMajor, leastMinor]] = [parts(version), parts(least)];
  if (major > leastMajor || (major === leastMajor && minor >= leastMinor)) return;
  throw new RiverSeedError(`${generator} ${least} or newer is needed; this is ${version}`);
}

/** Refuses a page in which one element stands in another, where nobody would see it. `where` names the page. */
export function refuseNested(page, where) {
  let depth = 0;
  for (const [, isEnd] of page.matchAll(/<(\/?)river-seed[\s>]/g)) {
    depth += isEnd ? -1 : 1;
    if (depth > 1) throw new RiverSeedError(`a river-seed stands inside another${where ? `: ${where}` : ""}`);
  }
}

const drawing = new Map();

/** Draws a map's picture once, however many pages ask for it at the same time, and returns its size. */
export function drawOnce(map, folder) {
  if (typeof map !== "string" || map.trim() === "")
    throw new RiverSeedError(
      `a word or a link is wanted, as "kauri" or "seed=kauri&land=valley", not ${JSON.stringify(map)}`,
    );
  const path = join(folder, fileOf(map));
  if (!drawing.has(path)) drawing.set(path, draw(map, path));
  return drawing.get(path);
}

async function draw(map, path) {
  if (!(await stat(path).catch(() => undefined))) {
    await mkdir(dirname(path), { recursive: true });
    await sharp(Buffer.from(svgOf(map)), { unlimited: true })
      .resize(WIDTH)
      .webp({ quality: QUALITY })
      .toFile(`${path}.new`);
    await rename(`${path}.new`, path);
  }
  return await sharp(path).metadata();
}

function svgOf(map) {
  try {
    const grown = grow(isLink(map) ? map : `seed=${encodeURIComponent(map)}`);
    const svg = grown.svg();
    grown.free();
    return svg;
  } catch (error) {
    throw error instanceof PageError ? new RiverSeedError(`no map of ${JSON.stringify(map)}: ${error.message}`) : error;
  }
}

function attributes(values) {
  return Object.entries(values)
    .map(([name, value]) => ` ${name}="${escaped(String(value))}"`)
    .join("");
}

/** Escapes a text for HTML, and for what reads HTML as a template: `${…}` in a notebook's cell, `{{…}}` in a page of Vue. */
function escaped(text) {
  return text.replace(/[&<>"'`\\${}]/g, (letter) => `&#${letter.charCodeAt(0)};`);
}
