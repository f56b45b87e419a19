// Makes what a page needs to show `<river-seed>`: the picture that readers without JavaScript see, drawn while the site is
// built, and the element's files. Eleventy, Astro, MDX, Hugo and the card share this file; copy it beside theirs.
//
// It takes `npm install riverseed sharp`.

import { createHash, randomUUID } from "node:crypto";
import { copyFile, mkdir, readFile, rename, rm, stat } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { grow, PageError, readLink } from "riverseed/node";
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

/**
 * Reads a map that is named by a word, by a link such as `seed=kauri&land=valley`, or by a page's address. Returns the canonical link, whose edition keeps
 * the picture and the element alike after an upgrade, a text alternative, and true if the map is more than the element draws.
 */
export function readMap(map) {
  if (typeof map !== "string" || map.trim() === "")
    throw new RiverSeedError(
      `a word or a link is wanted, as "kauri" or "seed=kauri&land=valley", not ${JSON.stringify(map)}`,
    );
  try {
    const { link, alternative, isMended, beyondElement } = readLink(map);
    if (isMended) tellOnce(`the link was damaged on its way, and is read as ${link}: ${JSON.stringify(map)}`);
    if (beyondElement.length > 0)
      tellOnce(`a picture without the element for ${JSON.stringify(map)}: ${beyondElement}`);
    return { link, alternative, isPictureAlone: beyondElement.length > 0 };
  } catch (error) {
    throw error instanceof PageError ? new RiverSeedError(`no map of ${JSON.stringify(map)}: ${error.message}`) : error;
  }
}

const told = new Set();

/** Tells the author something that stops no build. A page is built many times while its author writes. */
function tellOnce(message) {
  if (!told.has(message)) console.warn(`river-seed: ${message}`);
  told.add(message);
}

/** Returns the file name of a link's picture. It is a hash, since words may be any text, also `../`, and of all that decides the pixels. */
export function fileOf(link) {
  const hash = createHash("sha256").update(`${link} ${WIDTH} webp ${QUALITY}`).digest("hex");
  return `river-seed-${hash.slice(0, 16)}.webp`;
}

/**
 * Draws a map into a folder, unless its picture is there, and returns the attributes of the element and of the picture. A map that is
 * more than the element draws has the picture alone. `base` is the address of the folder, and `alt` a text alternative of the author's own.
 */
export async function embed(map, { folder, base, alt }) {
  const { link, alternative, isPictureAlone } = readMap(map);
  const { width, height } = await drawOnce(link, folder);
  const picture = {
    src: base + fileOf(link),
    alt: alt || alternative,
    width,
    height,
    style: "display:block;width:100%;height:auto",
  };
  if (isPictureAlone) return { picture };
  const element = { recipe: link, ...(alt && { alt }), style: "display:block" };
  return { script: `${base}river-seed.js`, element, picture };
}

/** Writes an embed as HTML. */
export function html({ script, element, picture }) {
  const img = `<img${attributes(picture)}>`;
  if (!element) return img;
  return `<script type="module" src="${escaped(script)}"></script><river-seed${attributes(element)}>${img}</river-seed>`;
}

/** Copies the element's files from the npm package into a folder. */
export async function copyElement(folder) {
  const list = fileURLToPath(import.meta.resolve("riverseed/integrity.json"));
  await mkdir(folder, { recursive: true });
  for (const file of await elementFiles(list)) await copyFile(join(dirname(list), file), join(folder, file));
}

/** Lists the files that a page with the element loads, of all that `integrity.json` of the npm package names. */
export async function elementFiles(list) {
  return Object.keys(JSON.parse(await readFile(list, "utf8"))).filter((file) => !UNUSED.has(file));
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

/** Parts of a page in which a tag is only text: comments, scripts and styles. */
const UNSEEN = /<!--[^]*?(?:-->|$)|<(script|style)\b[^]*?<\/\1\s*>/gi;

/** Refuses a page in which one element stands in another, where nobody would see it. `where` names the page. */
export function refuseNested(page, where) {
  let depth = 0;
  for (const [, isEnd] of page.replace(UNSEEN, "").matchAll(/<(\/?)river-seed[\s>]/g)) {
    depth = Math.max(0, depth + (isEnd ? -1 : 1));
    if (depth > 1) throw new RiverSeedError(`a river-seed stands inside another${where ? `: ${where}` : ""}`);
  }
}

const drawing = new Map();

/** Draws a link's picture, unless it is there, and returns its size. Pages that ask for it at the same time wait for one drawing. */
export function drawOnce(link, folder) {
  const path = join(folder, fileOf(link));
  // It is kept no longer, so that a failed drawing is tried again, and a deleted picture is drawn again.
  if (!drawing.has(path))
    drawing.set(
      path,
      draw(link, path).finally(() => drawing.delete(path)),
    );
  return drawing.get(path);
}

async function draw(link, path) {
  if (!(await stat(path).catch(() => undefined))) {
    await mkdir(dirname(path), { recursive: true });
    // Its own name, since other processes may draw the same map.
    const unfinished = `${path}.${randomUUID()}`;
    try {
      await sharp(Buffer.from(svgOf(link)), { unlimited: true })
        .resize(WIDTH)
        .webp({ quality: QUALITY })
        .toFile(unfinished);
      await rename(unfinished, path);
    } finally {
      await rm(unfinished, { force: true });
    }
  }
  return await sharp(path).metadata();
}

function svgOf(link) {
  const grown = grow(link);
  const svg = grown.svg();
  grown.free();
  return svg;
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
