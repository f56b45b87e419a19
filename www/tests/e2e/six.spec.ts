import { expect, type Locator, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import { violations } from "./axe.ts";
import { pixelsOf } from "./pixels.ts";
import { address, complaints, expectAddress, finished, openFinished, openFold } from "./riverpage.ts";

const LINK = "seed=kauri&land=island&attractors=400&style=ink&labels=none";
const NAMES = ["Original", "Momentum", "Curl", "Trimmed original", "Trimmed momentum", "Trimmed curl"];

function sheet(page: Page) {
  return page.getByRole("dialog", { name: "Six ways to grow" });
}

function variants(page: Page) {
  return sheet(page).locator(".variant");
}

async function allFinished(page: Page): Promise<void> {
  await expect(sheet(page).locator('.variant[data-state="finished"]')).toHaveCount(6);
}

async function openFromPanel(page: Page): Promise<void> {
  await openFold(page, "For the curious");
  await page.getByRole("button", { name: "Compare all six" }).click();
  await expect(sheet(page)).toBeVisible();
}

test("the panel opens six maps of the same attractors, each of its own pattern, and Escape leads back @core", async ({
  page,
}) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  await openFromPanel(page);
  await expect(variants(page).locator("b")).toHaveText(NAMES);
  await expect(sheet(page)).toContainText("the same 400 attractors of “kauri”");
  await allFinished(page);
  const pictures = new Set<string>();
  for (const canvas of await variants(page).locator("canvas").all()) pictures.add((await pixelsOf(canvas)).sha256);
  expect(pictures.size).toBe(6);
  // Trimming takes branches of the same trees.
  const ticks = await variants(page).evaluateAll((all) => all.map((one) => one.getAttribute("data-ticks")));
  expect(ticks.slice(3)).toEqual(ticks.slice(0, 3));
  await page.keyboard.press("Escape");
  await expect(sheet(page)).toBeHidden();
  await expect(page.getByRole("button", { name: "Compare all six" })).toBeFocused();
  expect(said).toEqual([]);
});

test("the six are drawn in ink, whatever the map is drawn in, with what trimming has cut in red", async ({ page }) => {
  await openFinished(page, LINK.replace("style=ink", "style=atlas"));
  await openFromPanel(page);
  await allFinished(page);
  const cut = (one: Locator) => one.locator(".variant-cut path").getAttribute("d");
  const trimmed = variants(page).filter({ hasText: /^Trimmed/ });
  await expect(trimmed).toHaveCount(3);
  for (const one of await trimmed.all()) await expect.poll(() => cut(one)).toMatch(/^M.*L/);
  for (const one of await variants(page)
    .filter({ hasNotText: /^Trimmed/ })
    .all())
    await expect.poll(() => cut(one)).toBe("");
  // The relief of an atlas page would hide the differences.
  const canvas = variants(page).first().locator("canvas");
  const { width, height, sha256 } = await pixelsOf(canvas);
  const values = { growth: "colonize", attractors: "400", style: "ink", labels: "none", width: "28", courses: "grown" };
  const paper = { scatter: "random", reach: "2.3", kill: "1.1", step: "0.38", momentum: "0", curl: "0", stretch: "8" };
  const asGrown = {
    valleys: "0",
    trim: "0",
    "trim-variation": "0",
    "tributary-spacing": "0",
    simplify: "0",
    meander: "none",
  };
  const link = new URLSearchParams({
    seed: "kauri",
    land: "island",
    ...values,
    ...paper,
    ...asGrown,
  });
  expect(sha256).toBe(pictureOf(`${link}`, width, height).sha256);
  await expect(sheet(page)).toContainText("What trimming cuts is red in the end.");
});

test("the one that is chosen is taken for the map, with as many attractors as it was shown with @core", async ({
  page,
}) => {
  await openFinished(page, "seed=kauri&land=island&growth=drainage&attractors=9000&style=ink&width=9");
  await openFromPanel(page);
  await expect(sheet(page)).toContainText("the same 3,000 attractors");
  await allFinished(page);
  await variants(page).filter({ hasText: "Trimmed curl" }).click();
  await expect(sheet(page)).toBeHidden();
  await expectAddress(page, "growth", "colonize");
  await expectAddress(page, "attractors", "3000");
  await expectAddress(page, "width", "9");
  await expectAddress(page, "view", null);
  await finished(page);
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  await expectAddress(page, "attractors", "9000");
});

test("the address asks for them while they are seen, and is never part of the recipe", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto(`./?view=six&${LINK}`);
  await allFinished(page);
  await expectAddress(page, "view", "six");
  expect(address(page).get("attractors")).toBe("400");
  await sheet(page).getByRole("button", { name: "Copy link" }).click();
  await expect(sheet(page).getByRole("status")).toHaveText("Link copied.");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(page.url());
  await sheet(page).getByRole("button", { name: "Back to the map" }).click();
  await expectAddress(page, "view", null);
  await finished(page);
  await expect(page.locator("#notices")).toBeHidden();
  await page.keyboard.press("l");
  await expect(page.locator("#shared")).toHaveText("Link copied.");
  expect(await page.evaluate(() => navigator.clipboard.readText())).not.toContain("view");
});

test("another link that asks for them has them of its own", async ({ page }) => {
  const said = complaints(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./?seed=one&attractors=200&view=six");
  await allFinished(page);
  const first = (await pixelsOf(variants(page).first().locator("canvas"))).sha256;
  await page.evaluate(() => {
    location.hash = "seed=two&attractors=250&view=six";
  });
  await expect(sheet(page)).toContainText("the same 250 attractors of “two”");
  await expect(variants(page).locator("b")).toHaveText(NAMES);
  await allFinished(page);
  expect((await pixelsOf(variants(page).first().locator("canvas"))).sha256).not.toBe(first);
  await expectAddress(page, "seed", "two");
  await expectAddress(page, "view", "six");
  await page.goBack();
  await expect(sheet(page)).toContainText("of “one”");
  await allFinished(page);
  expect((await pixelsOf(variants(page).first().locator("canvas"))).sha256).toBe(first);
  await variants(page).filter({ hasText: "Trimmed curl" }).click();
  await expectAddress(page, "seed", "one");
  await expect(sheet(page)).toBeHidden();
  expect(said).toEqual([]);
});

test("another view is told of", async ({ page }) => {
  await openFinished(page, `${LINK}&view=seven`);
  await expect(page.locator("#notices")).toContainText("view");
  await expect(sheet(page)).toBeHidden();
});

test("all six keep the same tick, also where they are held, and are played again by keys alone", async ({ page }) => {
  await page.goto(`./?view=six&${LINK.replace("400", "2500")}`);
  const play = sheet(page).getByRole("button", { name: /^(Pause|Play|Replay)$/ });
  await expect(play).toBeFocused();
  await expect(variants(page).first()).toHaveAttribute("data-ticks", /[1-9]/);
  await page.keyboard.press("Space");
  // The renderer says so later; or they were finished, and are played again.
  await expect(variants(page).and(page.locator(':is([data-state="paused"], [data-state="finished"])'))).toHaveCount(6);
  if ((await variants(page).and(page.locator('[data-state="paused"]')).count()) > 0) {
    await expect(play).toHaveText("Play");
    const states = await variants(page).evaluateAll((all) =>
      all.filter((one) => one.getAttribute("data-state") === "paused").map((one) => one.getAttribute("data-ticks")),
    );
    expect(new Set(states).size).toBe(1);
    await page.keyboard.press("Space");
  }
  await allFinished(page);
  await expect(play).toHaveText("Replay");
  await expect(sheet(page).getByRole("status")).toHaveText("All six are finished.");
  await page.keyboard.press("Space");
  await expect(play).toHaveText("Pause");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await expect(variants(page).first()).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(sheet(page)).toBeHidden();
  await expectAddress(page, "growth", "colonize");
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 370, 320]) {
    test(`axe finds nothing, and nothing is cut off: ${colorScheme}, ${width} wide`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 700 });
      await openFinished(page, LINK);
      await openFromPanel(page);
      await allFinished(page);
      expect(await violations(page)).toEqual([]);
      expect(await sheet(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBe(0);
    });
  }
}

test("at 200 % zoom each of the six can be read and chosen", async ({ page }) => {
  await page.setViewportSize({ width: 720, height: 450 });
  await openFinished(page, LINK);
  await openFromPanel(page);
  await allFinished(page);
  expect(await sheet(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBe(0);
  for (const variant of await variants(page).all()) {
    await variant.scrollIntoViewIfNeeded();
    await expect(variant.locator("b")).toBeInViewport();
    await variant.click({ trial: true });
  }
  await expect(sheet(page).getByRole("button", { name: "Back to the map" })).toBeInViewport();
});

test("in forced colours, and from right to left, all of it is there", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await openFinished(page, LINK.replace("kauri", "נהר"));
  await page.evaluate(() => document.documentElement.setAttribute("dir", "rtl"));
  await openFromPanel(page);
  await allFinished(page);
  expect(await violations(page)).toEqual([]);
  expect(await sheet(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBe(0);
  const [first, second] = await Promise.all([0, 1].map((i) => variants(page).nth(i).boundingBox()));
  expect(first?.x).toBeGreaterThan(second?.x ?? 0);
});
