import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { showsRiver } from "./elsewhere.ts";
import { complaints } from "./riverpage.ts";

const POST = "./examples/blog.html";

test.use({ reducedMotion: "reduce" });

/** Without the buttons, which stand on the rivers. */
function hideButtons(page: Page): Promise<void> {
  return page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync("river-seed::part(button) { visibility: hidden }");
    document.adoptedStyleSheets.push(sheet);
  });
}

test("each river of the post is the one that its link leads to @core", async ({ page }) => {
  const said = complaints(page);
  await page.goto(POST);
  await hideButtons(page);
  const rivers = await page.locator("river-seed").all();
  expect(rivers).toHaveLength(3);
  for (const river of rivers) {
    const link = await river.locator("a").evaluate((a: HTMLAnchorElement) => a.search.slice(1));
    await expect.poll(() => showsRiver(page, river, link), link).toBe(true);
  }
  expect(said).toEqual([]);
});

test("the text never moves, from the first paint to the last river", async ({ page }) => {
  await page.addInitScript(() => {
    const shifts: number[] = [];
    Object.assign(globalThis, { shifts });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) shifts.push((entry as unknown as { value: number }).value);
    }).observe({ type: "layout-shift", buffered: true });
  });
  await page.goto(POST);
  for (const river of await page.locator("river-seed").all()) {
    await river.scrollIntoViewIfNeeded();
    await expect(river.locator("canvas")).toHaveCount(1);
  }
  expect(await page.evaluate(() => (globalThis as unknown as { shifts: number[] }).shifts)).toEqual([]);
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 820, 390]) {
    test(`the post is sound: ${colorScheme}, ${width} wide`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 900 });
      await page.goto(POST);
      await expect(page.locator("river-seed").first().locator("canvas")).toHaveCount(1);
      expect(await violations(page)).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    });
  }
}
