/** The page without a connection, after a visit. */

import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { BrowserContext, Page } from "@playwright/test";
import sharp from "sharp";
import { complaints, expectAddress, expectPictureOfAddress, finished } from "./riverpage.ts";
import { expect, type Host, test } from "./widget/hosts.ts";

/** The built site. */
const SITE = fileURLToPath(new URL("../../dist", import.meta.url));

test.use({ serviceWorkers: "allow" });

/** Visits the page until it is kept. */
async function visit(page: Page, address = "./"): Promise<void> {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto(address);
  await finished(page);
  await page.evaluate(() => navigator.serviceWorker.ready);
  // Active when it has fetched everything.
  await page.waitForFunction(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    return registration?.active?.state === "activated";
  });
}

/** Serves the site from a host that can be cut off. */
function served(host: Host): string {
  host.folder("/", SITE);
  host.answer("/", { body: readFileSync(join(SITE, "index.html")) });
  host.answer("/gallery/", { body: readFileSync(join(SITE, "gallery/index.html")) });
  return `${host.origin}/`;
}

/** Cuts or mends the connection. Browsers differ in whether a service worker is offline with its page, so the host is cut, too. */
async function cut(context: BrowserContext, host: Host, isCut = true): Promise<void> {
  host.isCut = isCut;
  await context.setOffline(isCut);
}

async function isControlled(page: Page): Promise<boolean> {
  return await page.evaluate(() => navigator.serviceWorker.controller !== null);
}

test("after a visit the map is drawn without a connection, with names, and so is any other @core", async ({
  page,
  context,
  blog,
}) => {
  const said = complaints(page);
  const site = served(blog);
  await visit(page, `${site}?seed=kauri&style=atlas&labels=some&attractors=3000`);
  await cut(context, blog);
  await page.reload();
  expect(await page.evaluate(() => fetch("./digest.html").catch(() => "offline"))).toBe("offline");
  await finished(page);
  await expect(page.getByRole("img", { name: /Its greatest rivers: / })).toBeVisible();
  await page.goto(`${site}?seed=moa&attractors=900&style=night`);
  await expectPictureOfAddress(page);
  await page.goto(site);
  await finished(page);
  expect(said.filter((text) => !text.includes("ERR_INTERNET_DISCONNECTED"))).toEqual([]);
});

test("without a connection land is drawn, too", async ({ page, context, blog }) => {
  await visit(page, `${served(blog)}?attractors=300`);
  await cut(context, blog);
  await page.reload();
  await finished(page);
  await page.getByRole("button", { name: "Draw", exact: true }).click();
  const box = await page.locator("#sketch").boundingBox();
  if (!box) throw new Error("there is nothing to draw on");
  const to = (x: number, y: number) => page.mouse.move(box.x + box.width * x, box.y + box.height * y, { steps: 5 });
  await to(0.3, 0.3);
  await page.mouse.down();
  for (const [x, y] of [
    [0.7, 0.3],
    [0.7, 0.7],
    [0.3, 0.7],
  ] as const)
    await to(x, y);
  await page.mouse.up();
  await expectAddress(page, "land", "drawn");
});

test("of the gallery there is what has been seen", async ({ page, context, blog }) => {
  const site = served(blog);
  await visit(page, `${site}?attractors=300`);
  await page.goto(`${site}gallery/few.html`);
  expect(await isControlled(page)).toBe(true);
  const picture = page.getByRole("main").locator("img");
  const isThere = () => picture.evaluate((img: HTMLImageElement) => img.complete && img.naturalWidth > 0);
  await expect.poll(isThere).toBe(true);
  // A picture is put by after it is shown.
  await page.waitForFunction(async () => (await caches.match("few.webp")) !== undefined);
  await cut(context, blog);
  await page.reload();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Few");
  await expect.poll(isThere).toBe(true);
  expect(await page.evaluate(() => [...document.styleSheets].map(({ cssRules }) => cssRules.length > 0))).toEqual([
    true,
    true,
  ]);
  await expect(page.goto(`${site}gallery/skye.html`)).rejects.toThrow();
});

test("without a connection the game is there, and there is a link to the gallery only once it has been seen", async ({
  page,
  context,
  blog,
}) => {
  const site = served(blog);
  await visit(page, `${site}?attractors=300`);
  await page.reload();
  await finished(page);
  const gallery = page.getByRole("link", { name: "Gallery" });
  await expect(gallery).toBeVisible();
  await cut(context, blog);
  await expect(gallery).toBeHidden();
  await page.reload();
  await finished(page);
  await expect(gallery).toBeHidden();
  await page.getByRole("button", { name: "Help and keys" }).click();
  await expect(page.locator(".docs-link")).toBeHidden();
  await page.getByRole("link", { name: "real or grown?" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  await expect(page.getByRole("button", { name: "Real", exact: true })).toBeEnabled();
  await cut(context, blog, false);
  await page.goto(`${site}gallery/`);
  await page.goto(`${site}?attractors=300`);
  await finished(page);
  await expect(gallery).toBeVisible();
  await cut(context, blog);
  await page.reload();
  await finished(page);
  await expect(gallery).toBeVisible();
  await gallery.click();
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
});

test("the element's files and the page for iframes go by untouched", async ({ page }) => {
  await visit(page, "./?attractors=300");
  const answers = new Map<string, boolean>();
  page.on("response", (response) => answers.set(new URL(response.url()).pathname, response.fromServiceWorker()));
  await page.reload();
  await finished(page);
  expect(await isControlled(page)).toBe(true);
  expect(answers.get("/")).toBe(true);
  await page.evaluate(() => Promise.all(["./widget/river-seed.js", "./embed-host.js"].map((file) => fetch(file))));
  await page.goto("./embed.html?attractors=300");
  await expect(page.locator("html")).toHaveAttribute("data-state", "ready");
  for (const path of ["/widget/river-seed.js", "/embed-host.js", "/embed.html"])
    expect(answers.get(path), path).toBe(false);
});

test("an open page keeps its version; the next visit has the new one @core", async ({ page, blog, context }) => {
  const html = await readFile(join(SITE, "index.html"), "utf8");
  const worker = await readFile(join(SITE, "service-worker.js"), "utf8");
  const revision = /url:`index\.html`,revision:`(\w+)`/.exec(worker)?.[1] ?? "";
  expect(revision).not.toBe("");
  blog.folder("/", SITE);
  const publish = (version: string): void => {
    const text = html.replace("Type a word. Get a country.", version);
    for (const path of ["/", "/index.html"]) blog.answer(path, { body: text });
    blog.answer("/service-worker.js", { body: worker.replace(revision, version) });
  };
  publish("first");
  await visit(page, `${blog.origin}/?attractors=300`);
  await page.reload();
  expect(await isControlled(page)).toBe(true);
  publish("second");
  const waits = page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    await registration?.update();
    while (registration?.waiting === null) await new Promise((resume) => requestAnimationFrame(resume));
  });
  await waits;
  await page.reload();
  await finished(page);
  await expect(page.locator(".masthead p")).toHaveText("first");
  // What is fetched late is of the page's version, too.
  const other = await context.newPage();
  await page.close();
  await expect
    .poll(async () => {
      await other.goto("about:blank");
      await other.goto(`${blog.origin}/?attractors=300`);
      return await other.locator(".masthead p").textContent();
    })
    .toBe("second");
});

test("where storage is refused the page is as ever", async ({ page }) => {
  const said = complaints(page);
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "serviceWorker", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./?attractors=300");
  await finished(page);
  expect(said).toEqual([]);
});

test("it can be installed: icons are as large as the manifest says", async ({ page, request }) => {
  await page.goto("./?attractors=300");
  const address = await page.locator('link[rel="manifest"]').getAttribute("href");
  const response = await request.get(address ?? "");
  const { icons, start_url } = (await response.json()) as {
    icons: { src: string; sizes: string; purpose: string }[];
    start_url: string;
  };
  expect(start_url).toBe("./");
  expect(icons.map(({ sizes, purpose }) => `${sizes} ${purpose}`)).toEqual([
    "any any",
    "192x192 any",
    "512x512 any",
    "512x512 maskable",
  ]);
  for (const { src, sizes } of icons) {
    const { width, height, format } = await sharp(await (await request.get(`./${src}`)).body()).metadata();
    if (format !== "svg") expect(`${width}x${height}`).toBe(sizes);
  }
});
