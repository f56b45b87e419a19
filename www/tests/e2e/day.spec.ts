/** The country of the day, at the page's bare address. */

import { expect, test } from "@playwright/test";
import { wordOf } from "../../src/apps/page/day/day.ts";
import { address, expectAddress, finished, onDay } from "./riverpage.ts";

const DAY = "2026-07-14T23:30";
const WORD = wordOf(new Date(DAY));

test("the bare address shows the word of the day, which typing replaces, and says that it is @core", async ({
  page,
}) => {
  await onDay(page, DAY);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./");
  await finished(page);
  const seed = page.getByRole("textbox", { name: "Seed" });
  await expect(seed).toHaveValue(WORD);
  await expect(page.locator("#caption")).toContainText("Country of the day");
  await expect.poll(() => address(page).toString()).toBe(new URLSearchParams({ seed: WORD, edition: "1" }).toString());
  await page.keyboard.type("Thornwick");
  await expect.poll(() => address(page).toString()).toBe("seed=Thornwick&edition=1");
  await expect(page.locator("#caption")).not.toContainText("Country of the day");
});

test("a link shows its own country on any day", async ({ page }) => {
  await onDay(page, DAY);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./?seed=rimu&attractors=300&labels=none");
  await finished(page);
  await expectAddress(page, "seed", "rimu");
  await expect(page.locator("#caption")).not.toContainText("Country of the day");
});

test("on a phone it is said, too, and in sight", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await onDay(page, DAY);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./");
  await finished(page);
  await expect(page.locator("#of-the-day")).toHaveText("Country of the day");
  await expect(page.locator("#of-the-day")).toBeInViewport({ ratio: 1 });
});
