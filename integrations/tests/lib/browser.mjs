// A built site in a real browser, served from under a path, as a reader has it.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { buffer } from "node:stream/consumers";
import { after, before } from "node:test";
import { ours } from "./workshop.mjs";

const { chromium } = ours("playwright-core");

const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webp": "image/webp",
};

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env["HEADLESS_SHELL"] });
});
// None was opened if all tests of a file are skipped.
after(() => browser?.close());

/** Opens an empty page, without animation. */
export async function openPage(options) {
  const context = await browser.newContext({
    reducedMotion: "reduce",
    viewport: { width: 760, height: 2400 },
    ...options,
  });
  return { page: await context.newPage(), close: () => context.close() };
}

/**
 * Serves a folder under a path; what was asked for and is not there is noted. `take` answers what is sent, with a status.
 */
export async function serve(folder, path, take) {
  const missing = [];
  const server = createServer(async (request, response) => {
    const { url, method } = request;
    if (take && method === "POST") return void response.writeHead(await take(request, await buffer(request))).end();
    const asked = decodeURIComponent(new URL(url, "http://host").pathname);
    try {
      if (!asked.startsWith(path)) throw new Error("outside");
      const file = join(folder, normalize(`/${asked.slice(path.length)}`).replace(/\/$/, "/index.html"));
      const body = await readFile(file);
      response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" }).end(body);
    } catch {
      missing.push(asked);
      response.writeHead(404).end();
    }
  });
  // A test that fails leaves it open; it keeps no run from ending.
  server.unref();
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return {
    address: `http://127.0.0.1:${server.address().port}${path}`,
    missing,
    [Symbol.asyncDispose]: () => {
      server.closeAllConnections();
      return new Promise((done) => server.close(done));
    },
  };
}

/**
 * Opens a page of a built site without JavaScript and with it, and expects what every integration promises: a picture
 * first, the rivers in its place, and that nothing moves. `pictures` are as many as `rivers`, unless it says otherwise; `picture` is
 * where a screenshot goes. Without fonts, none that come late move what this is not about.
 */
export async function expectRivers(
  folder,
  { rivers, pictures = rivers, path = "/blog/", page = "", picture, hasFonts = true },
) {
  const site = await serve(folder, path);
  try {
    await expectPictures(site.address + page, pictures);
    await expectTakeover(site.address + page, { rivers, picture, hasFonts });
    assert.deepEqual(site.missing, [], "everything that the page asks for is there");
  } finally {
    await site[Symbol.asyncDispose]();
  }
}

async function expectPictures(address, count) {
  const { page, close } = await openPage({ javaScriptEnabled: false });
  await page.goto(address);
  const pictures = page.locator("river-seed > img");
  assert.equal(await pictures.count(), count, "a picture for each map, without JavaScript");
  for (const picture of await pictures.all()) {
    assert.ok(await picture.isVisible(), "the picture is seen");
    const { src, alt, natural, shown } = await picture.evaluate((img) => ({
      src: img.getAttribute("src"),
      alt: img.alt,
      natural: img.naturalWidth / img.naturalHeight,
      shown: img.clientWidth / img.clientHeight,
    }));
    assert.ok(natural > 0, `the picture is loaded: ${src}`);
    assert.ok(Math.abs(natural / shown - 1) < 0.01, `it has its own shape: ${src}`);
    assert.notEqual(alt, "", "it has a text alternative");
  }
  await close();
}

async function expectTakeover(address, { rivers, picture, hasFonts }) {
  const { page, close } = await openPage();
  if (!hasFonts) await page.route("**/*.woff2", (route) => route.fulfill({ body: "" }));
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.addInitScript(() => {
    globalThis.seen_ = { complete: 0, shifts: 0 };
    document.addEventListener("complete", () => seen_.complete++, true);
    new PerformanceObserver((list) => {
      for (const { value } of list.getEntries()) seen_.shifts += value;
    }).observe({ type: "layout-shift", buffered: true });
  });
  await page.goto(address);
  await page.waitForFunction((rivers) => seen_.complete === rivers, rivers, { timeout: 60_000 });
  // The old content goes two frames after the map is there; shifts are told a frame later.
  await page.evaluate(async () => {
    for (let i = 0; i < 6; i++) await new Promise(requestAnimationFrame);
  });
  const maps = page.locator("river-seed");
  for (const map of await maps.all()) {
    assert.ok(await map.locator("canvas").isVisible(), "the element's own map is seen");
    assert.equal(
      await map.evaluate(({ children }) => [...children].some((one) => one.checkVisibility())),
      false,
      "in place of the picture",
    );
  }
  assert.equal(await page.evaluate(() => seen_.shifts), 0, "layout shift");
  assert.deepEqual(complaints, [], "the console is silent");
  if (picture) await page.locator("body").screenshot({ path: picture });
  await close();
}

/** The address of a picture whose name is a hash. */
const PICTURE = /^\/blog\/riverseed\/river-seed-[0-9a-f]{16}\.(webp|png)$/;
const ATTRIBUTES = ["alt", "edition", "height", "recipe", "seed", "src", "style", "width"];

/**
 * Opens a page of hostile words and expects them as text and nowhere else. `own` and `attributes` are what the system itself
 * writes into a post besides, and `pictures` the addresses that it gives to pictures.
 */
export async function expectHarmless(
  folder,
  words,
  { page = "", pictures = PICTURE, attributes = [], own = "h1" } = {},
) {
  const site = await serve(folder, "/blog/");
  const { page: tab, close } = await openPage();
  try {
    await tab.goto(site.address + page);
    const found = await tab.evaluate(contents, own);
    assert.equal(found.isHit, false, "no word is run as a script");
    assert.deepEqual(found.asked, words, "every word arrives as it was written");
    assert.deepEqual(found.strange, [], "no word becomes an element");
    const known = [...ATTRIBUTES, ...attributes];
    assert.deepEqual(
      found.attributes.filter((name) => !known.includes(name)),
      [],
      "no word becomes an attribute",
    );
    for (const [i, { source, alt }] of found.pictures.entries()) {
      assert.match(source, pictures, "no word is in a path");
      assert.ok(alt.includes(words[i]), `a text alternative is whole: ${alt}`);
    }
    assert.deepEqual(site.missing, [], "no word asks for a file");
  } finally {
    await close();
    await site[Symbol.asyncDispose]();
  }
}

/** Lists, in a page, the seeds and pictures of its post, and all elements that no shortcode writes. */
function contents(own) {
  const all = (selector) => [...document.querySelectorAll(selector)];
  const written = `h1, p, river-seed, river-seed > img, script[src$="/riverseed/river-seed.js"]:empty, ${own}`;
  const given = (map) => map.getAttribute("seed") ?? map.getAttribute("recipe");
  const seed = (map) => new URLSearchParams(map.getAttribute("recipe")).get("seed");
  return {
    isHit: "hit" in globalThis,
    asked: all("main river-seed").map((map) => seed(map) ?? given(map)),
    strange: all("main *")
      .filter((one) => !one.matches(written))
      .map((one) => one.outerHTML),
    attributes: all("main river-seed, main img").flatMap((one) => one.getAttributeNames()),
    pictures: all("main img").map((one) => ({ source: one.getAttribute("src"), alt: one.alt })),
  };
}
