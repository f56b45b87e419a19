import { expect, type Page, test } from "@playwright/test";
import {
  expectPictureOfAddress,
  finished,
  fixChance,
  openBegun,
  openFinished,
  ownClock,
  stopClock,
} from "./riverpage.ts";

const LINK = "seed=kauri&attractors=600";
const last = (page: Page) => page.locator(".last-picture");
const throwDice = (page: Page) => page.getByRole("button", { name: "A new seed by chance" }).click();

/** Opens a finished map whose page's clock stands still. */
async function openStill(page: Page): Promise<void> {
  await fixChance(page);
  await ownClock(page);
  await openFinished(page, LINK);
  await stopClock(page);
}

test("the last map stays until the next is finished, which is soon @core", async ({ page }) => {
  await openStill(page);
  await throwDice(page);
  await expect(last(page)).toBeVisible();
  await page.clock.runFor(500);
  await finished(page);
  await expect(last(page)).toHaveCount(0);
  await expectPictureOfAddress(page);
});

test("thrown again and again, the dice keep the last whole map", async ({ page }) => {
  await openStill(page);
  const shown = (): Promise<string> => last(page).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await throwDice(page);
  const first = await shown();
  await throwDice(page);
  expect(await shown()).toBe(first);
  await expect(last(page)).toHaveCount(1);
});

test("who waits long is shown how far the next map is", async ({ page }) => {
  await openStill(page);
  await page.evaluate(() => {
    // Nothing grows in a hidden tab.
    Object.defineProperty(document, "hidden", { configurable: true, value: true });
    document.dispatchEvent(new Event("visibilitychange"));
  });
  await throwDice(page);
  await page.clock.runFor(2400);
  await expect(last(page)).toBeVisible();
  await page.clock.runFor(200);
  await expect(last(page)).toHaveCount(0);
});

test("whoever moves the map meanwhile moves the next one", async ({ page }) => {
  await openStill(page);
  await throwDice(page);
  await page.getByRole("button", { name: "Zoom in" }).click();
  await expect(last(page)).toHaveCount(0);
});

test("the poster stays until the first map is finished @core", async ({ page }) => {
  await openBegun(page);
  const opacity = () => page.locator("#canvas").evaluate((canvas) => getComputedStyle(canvas).opacity);
  await expect(page.locator(".poster img")).toBeVisible();
  expect(await opacity()).toBe("0");
  await page.clock.resume();
  await finished(page);
  await expect.poll(opacity).toBe("1");
});
