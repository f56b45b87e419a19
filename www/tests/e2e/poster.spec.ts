/** The poster, which stands for the map of a visit without a link until that is there. */

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, type Page, test } from "@playwright/test";
import sharp from "sharp";
import { POSTERS } from "../../build/poster.ts";
import { engine } from "../core.ts";
import { address, complaints, finished, onDay, openFinished, shown } from "./riverpage.ts";
import { core } from "./tiers.ts";

const WINDOWS = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 820, height: 1180 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
];

/** The posters that are fetched. Call before `goto`. */
function posters(page: Page): string[] {
  const asked: string[] = [];
  page.on("request", (request) => {
    const file = /\/poster\/(.*)$/.exec(request.url())?.[1];
    if (file !== undefined) asked.push(file);
  });
  return asked;
}

for (const size of WINDOWS)
  test(`it stands where the map will: ${size.width} by ${size.height}${core(size.width === 1440 || size.width === 390)}`, async ({
    page,
  }) => {
    await page.setViewportSize(size);
    const asked = posters(page);
    await openFinished(page);
    const { framing } = await shown(page);
    const poster = await page.locator(".poster img").boundingBox();
    if (!poster) throw new Error("there is no poster");
    const across = size.width / framing[2];
    // The map is the middle two thirds of it.
    expect(Math.abs(poster.width / 1.5 - across)).toBeLessThan(2);
    expect(Math.abs(poster.x + poster.width / 6 + framing[0] * across)).toBeLessThan(2);
    expect(Math.abs(poster.y + poster.height / 6 + framing[1] * across)).toBeLessThan(2);
    expect(asked).toHaveLength(1);
  });

for (const colorScheme of ["light", "dark"] as const)
  for (const size of [
    { width: 1200, height: 800 },
    { width: 500, height: 800 },
  ])
    test(`it is of the very map that comes: ${colorScheme}, ${size.width} wide`, async ({ page }) => {
      await page.setViewportSize(size);
      await page.emulateMedia({ colorScheme });
      const asked = posters(page);
      const said = complaints(page);
      await openFinished(page);
      const values = new URLSearchParams(POSTERS.find(({ file }) => file === asked[0])?.link);
      await expect(page.locator("html")).toHaveAttribute("data-style", values.get("style") ?? "atlas");
      // The page itself chose the style, so the address does not name it.
      values.delete("style");
      await expect.poll(() => address(page).toString()).toBe(engine.readLink(values.toString()).link);
      expect(asked).toHaveLength(1);
      expect(said).toEqual([]);
    });

/** Returns the share of pixels in which two pictures differ so far that it is no matter of compression. */
async function shareApart(one: Buffer, other: Buffer): Promise<number> {
  const pixels = (picture: Buffer) => sharp(picture).removeAlpha().blur(1).raw().toBuffer();
  const [a, b] = await Promise.all([pixels(one), pixels(other)]);
  const apart = a.filter((value, i) => Math.abs(value - (b[i] ?? 0)) > 40).length;
  return apart / a.length;
}

for (const size of [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
])
  test(`its names and its scale bar are the map's: ${size.width} wide`, async ({ page }) => {
    await page.setViewportSize(size);
    await openFinished(page);
    const onlyTheFrame = (): void => {
      for (const other of document.querySelectorAll<HTMLElement>("main > *, .stage > *"))
        other.style.visibility = "hidden";
      for (const shown of document.querySelectorAll<HTMLElement>("#frame, .poster, #canvas"))
        shown.style.visibility = "visible";
    };
    await page.evaluate(onlyTheFrame);
    const map = await page.screenshot();
    await page
      .locator("#canvas")
      .evaluate((canvas) => Object.assign(canvas.style, { opacity: "0", transition: "none" }));
    // Letters at other places would be some 0.3% of the picture.
    expect(await shareApart(map, await page.screenshot())).toBeLessThan(0.001);
  });

test("a visit with a link neither shows nor fetches it @core", async ({ page }) => {
  const asked = posters(page);
  await openFinished(page, "seed=rimu&attractors=300");
  await expect(page.locator(".poster")).toBeHidden();
  await page.goto("./#seed=moa&attractors=300");
  await expect(page.locator(".poster")).toBeHidden();
  expect(asked).toEqual([]);
});

test("on a day without a poster none is shown or fetched: no country stands for another @core", async ({ page }) => {
  const asked = posters(page);
  await onDay(page, "2026-07-14T12:00");
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./");
  await expect(page.locator(".poster")).toBeHidden();
  await finished(page);
  expect(asked).toEqual([]);
});

test("it is seen until the map comes, and a canvas without a picture hides none of it", async ({ page }) => {
  await page.route("**/*.wasm", () => {});
  await onDay(page);
  await page.goto("./");
  const poster = page.locator(".poster img");
  await expect.poll(() => poster.evaluate((img: HTMLImageElement) => img.naturalWidth)).toBeGreaterThan(0);
  await expect(page.locator("#canvas")).toHaveCSS("opacity", "0");
});

test("visitors without scripts see it", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  const fetched = page.waitForResponse("**/poster/*.webp");
  await page.goto(baseURL ?? "");
  expect((await fetched).ok()).toBe(true);
  await expect(page.locator(".poster img")).toBeVisible();
  // Nothing is promised that does not come, and nothing is there to press.
  await expect(page.locator("noscript p")).toBeVisible();
  await expect(page.getByText("Preparing the rivers…")).toBeHidden();
  await expect(page.locator(".bar, .styles, .zoom").filter({ visible: true })).toHaveCount(0);
  await context.close();
});

test("posters are small, and as large as the page says", async () => {
  const html = readFileSync(fileURLToPath(new URL("../../dist/index.html", import.meta.url)), "utf8");
  for (const { file } of POSTERS) {
    const bytes = readFileSync(fileURLToPath(new URL(`../../dist/poster/${file}`, import.meta.url)));
    expect(bytes.length, file).toBeLessThan(42_000);
    const { width, height } = await sharp(bytes).metadata();
    expect(html).toContain(`="./poster/${file}" width="${width}" height="${height}"`);
  }
});
