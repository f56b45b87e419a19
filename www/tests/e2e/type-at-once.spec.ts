import { expect, test } from "@playwright/test";
import { expectAddress, openFinished } from "./riverpage.ts";

const focused = (): string => document.activeElement?.id ?? "";

test("who comes without a link types a word at once: a name and Enter are a country @core", async ({ page }) => {
  await openFinished(page);
  expect(await page.evaluate(focused)).toBe("seed");
  await page.keyboard.type("Anna");
  await page.keyboard.press("Enter");
  await expectAddress(page, "seed", "Anna");
});

test("the focus stays where somebody has put it meanwhile", async ({ page }) => {
  await page.addInitScript(() => {
    addEventListener("DOMContentLoaded", () => document.querySelector<HTMLElement>(".gallery-link")?.focus());
  });
  await openFinished(page);
  expect(await page.evaluate(() => document.activeElement?.className)).toBe("gallery-link");
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  test("no keyboard comes up over the map", async ({ page }) => {
    await openFinished(page);
    expect(await page.evaluate(() => document.activeElement === document.body)).toBe(true);
  });
});
