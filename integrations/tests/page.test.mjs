// The folder that `riverseed page` writes, served under a path.

import assert from "node:assert/strict";
import { readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectRivers, openPage, serve } from "./lib/browser.mjs";
import { HOSTILE } from "./lib/hostile.mjs";
import { build, LOOKS, PACKAGE, WORKSHOP } from "./lib/workshop.mjs";

/** Serves a folder under a path while something looks at it in a browser. */
async function served(folder, path, look) {
  const site = await serve(folder, path);
  const { page, close } = await openPage();
  try {
    await look(page, site);
    assert.deepEqual(site.missing, [], "everything that the page asks for is there");
  } finally {
    await close();
    await site[Symbol.asyncDispose]();
  }
}

/** Writes the folder of a map. */
async function written(name, words) {
  const folder = join(WORKSHOP, "sites", name);
  rmSync(folder, { recursive: true, force: true });
  await build(WORKSHOP, "riverseed", ["page", "-o", folder, "--element", PACKAGE, "--attractors", "800", "--size", "800", ...words]);
  return folder;
}

test("a map's page: a picture without JavaScript, the rivers in its place, and nothing moves", async () => {
  const folder = await written("page", ["--seed", "kauri", "--address", "https://example.org/maps/kauri/"]);
  await expectRivers(folder, { rivers: 1, path: "/maps/kauri/", picture: join(LOOKS, "page.png"), hasFonts: false });
  await expectRivers(folder, { rivers: 1, path: "/elsewhere/", page: "embed.html" });
});

test("the frame that oEmbed gives shows the map on another page, as large as its shape says", async () => {
  const folder = await written("page-frame", ["--seed", "moa", "--aspect", "2", "--address", "https://example.org/moa/"]);
  const { html } = JSON.parse(readFileSync(join(folder, "oembed.json"), "utf8"));
  await served(folder, "/moa/", async (page, { address }) => {
    const post = html.replace("https://example.org/moa/", address);
    const blog = new URL("/post.html", address).href;
    await page.route(blog, (route) =>
      route.fulfill({ contentType: "text/html", body: `<!doctype html><body style="margin:0;width:700px">${post}` }),
    );
    await page.goto(blog);
    const map = page.frameLocator("iframe").locator("river-seed");
    await map.locator("canvas").waitFor();
    assert.deepEqual(await page.locator("iframe").evaluate(({ clientWidth, clientHeight }) => [clientWidth, clientHeight]), [700, 350]);
    const { width, height } = await map.boundingBox();
    assert.deepEqual([width, height], [700, 350], "the map fills the frame");
  });
});

for (const hasCors of [true, false])
  test(`in a frame without an origin, as WordPress makes it, there is ${hasCors ? "the map where the host sends CORS" : "the picture where the host sends no CORS"}`, async () => {
    const folder = await written("page-sandbox", ["--seed", "moa", "--address", "https://example.org/moa/"]);
    await served(folder, "/moa/", async (page, { address }) => {
      const blog = new URL("/post.html", address).href;
      const frame = `<iframe sandbox="allow-scripts" src="${address}embed.html" width="600" height="400"></iframe>`;
      await page.route(blog, (route) => route.fulfill({ contentType: "text/html", body: `<!doctype html><body>${frame}` }));
      if (hasCors)
        await page.route("**/element/**", async (route) => {
          const response = await route.fetch();
          await route.fulfill({ response, headers: { ...response.headers(), "access-control-allow-origin": "*" } });
        });
      await page.goto(blog);
      const map = page.frameLocator("iframe").locator("river-seed");
      if (hasCors) await map.locator("canvas").waitFor();
      else await page.waitForFunction(() => performance.getEntriesByType("resource").length > 0);
      await map.locator("img").waitFor({ state: hasCors ? "hidden" : "visible" });
      assert.equal(await map.locator("canvas").count(), hasCors ? 1 : 0);
    });
  });

test("hostile words are text on a map's page, and attributes hold them whole", async () => {
  // Those that could be markup; the others have a test of the command.
  for (const [i, word] of HOSTILE.slice(0, 4).entries()) {
    const folder = await written(`page-hostile-${i}`, [`--seed=${word}`, `--title=${word}`, `--description=${word}`]);
    await served(folder, "/", async (page, { address }) => {
      await page.goto(address);
      await page.locator("river-seed canvas").waitFor();
      const found = await page.evaluate(() => ({
        isHit: "hit" in globalThis,
        heading: document.querySelector("h1").textContent,
        seed: document.querySelector("river-seed").getAttribute("seed"),
        strange: document.querySelectorAll("body script, body b, body style, img[onerror]").length,
      }));
      assert.deepEqual(found, { isHit: false, heading: word, seed: word, strange: 0 });
    });
  }
});
