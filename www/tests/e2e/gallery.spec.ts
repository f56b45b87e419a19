/** The gallery, as it was built. */

import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import sharp from "sharp";
import { violations } from "./axe.ts";
import { complaints, expectPictureOfAddress } from "./riverpage.ts";
import { core } from "./tiers.ts";

const FOLDER = fileURLToPath(new URL("../../dist/gallery", import.meta.url));
const PAGES = readdirSync(FOLDER).filter((name) => name.endsWith(".html"));

function attributes(html: string, name: string): string[] {
  return [...html.matchAll(new RegExp(` ${name}="([^"]*)"`, "g"))].map(([, value = ""]) => value);
}

test("every page has a card of the size that it says", async () => {
  expect(PAGES.length).toBeGreaterThanOrEqual(25);
  for (const page of PAGES) {
    const html = readFileSync(join(FOLDER, page), "utf8");
    const said = (name: string) => new RegExp(`property="og:image${name}" content="([^"]+)"`).exec(html)?.[1] ?? "";
    const { width, height } = await sharp(join(FOLDER, said(""))).metadata();
    expect([width, height], page).toEqual([1200, 630]);
    expect([said(":width"), said(":height")], page).toEqual(["1200", "630"]);
    expect(said(":alt"), page).not.toBe("");
  }
});

test("every picture has the size that its page says, and everything that pages lead to is there @core", async () => {
  for (const page of PAGES) {
    const html = readFileSync(join(FOLDER, page), "utf8");
    for (const target of [...attributes(html, "href"), ...attributes(html, "src")]) {
      if (target.startsWith("data:")) continue;
      const file = resolve(FOLDER, target.replace(/\?.*/, ""));
      expect(existsSync(target.replace(/\?.*/, "").endsWith("/") ? join(file, "index.html") : file), target).toBe(true);
    }
    for (const [, src = "", width, height] of html.matchAll(/<img src="([^"]+)" width="(\d+)" height="(\d+)"/g)) {
      const size = await sharp(join(FOLDER, src)).metadata();
      expect([size.width, size.height], src).toEqual([Number(width), Number(height)]);
    }
  }
});

for (const colorScheme of ["light", "dark"] as const)
  for (const address of ["gallery/", "gallery/shire.html"])
    test(`axe finds nothing, and nothing is said or cut off: ${address}, ${colorScheme}${core(colorScheme === "light" && address === "gallery/")}`, async ({
      page,
    }) => {
      const said = complaints(page);
      await page.emulateMedia({ colorScheme });
      for (const width of [1440, 820, 320]) {
        await page.setViewportSize({ width, height: 800 });
        await page.goto(`./${address}`);
        expect(await violations(page)).toEqual([]);
        expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      }
      expect(said).toEqual([]);
    });

test("pictures far below are not fetched, and have their room before they come", async ({ page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.route("**/*.webp", (route) => route.abort());
  await page.setViewportSize({ width: 390, height: 700 });
  await page.goto("./gallery/");
  expect(asked.some((path) => path.endsWith("/few-overview.webp"))).toBe(false);
  for (const picture of await page.locator(".maps img").all()) {
    const shape = await picture.evaluate((img: HTMLImageElement) => {
      const { width, height } = img.getBoundingClientRect();
      return width / height / (Number(img.getAttribute("width")) / Number(img.getAttribute("height")));
    });
    expect(shape).toBeCloseTo(1, 1);
  }
});

test("from the page to a map of the gallery and back to the page, with the keyboard @core", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./?attractors=300");
  await page.getByRole("link", { name: "Gallery" }).focus();
  await page.keyboard.press("Enter");
  await expect(page).toHaveTitle("Gallery · Riverseed");
  await page.getByRole("link", { name: "Few" }).focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Few");
  await page.getByRole("link", { name: "Open it on the page" }).focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("textbox", { name: "Seed" })).toHaveValue("few");
  await expectPictureOfAddress(page);
});
