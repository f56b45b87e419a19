/** Keys of the whole page: where they mean something else, and what Escape takes back. */

import { expect, type Page, test } from "@playwright/test";
import { address, expectAddress, finished, openFinished, openPanel, ownClock, stopClock } from "./riverpage.ts";

const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&style=ink&labels=none";

function overlayCard(page: Page) {
  return page.locator(".inside-card");
}

function riverCard(page: Page) {
  return page.locator(".river-card");
}

test("no key reaches the map behind an open dialog @core", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("r");
  await expect.poll(() => address(page).get("seed")).not.toBe("kauri");
  const seed = address(page).get("seed");
  await finished(page);
  await page.keyboard.press("?");
  const sheet = page.getByRole("dialog", { name: "Riverseed" });
  await expect(sheet).toBeVisible();
  for (const key of ["Control+z", "r", "a", "w", "n"]) await page.keyboard.press(key);
  // Also where nothing of it has the focus.
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  for (const key of ["Control+z", "r", "a", "w", " "]) await page.keyboard.press(key);
  await page.keyboard.press("Escape");
  await expect(sheet).toBeHidden();
  await finished(page);
  expect(address(page).get("seed")).toBe(seed);
  await expect(overlayCard(page)).toBeHidden();
  await expect(page.locator("html")).not.toHaveAttribute("data-map-alone");
  await page.keyboard.press("Control+z");
  await expectAddress(page, "seed", "kauri");
});

test("on a slider letters are keys, and where a list has the focus a letter picks from it but undo is undo", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await openPanel(page);
  await page.getByRole("slider", { name: "How many rivers" }).focus();
  await page.keyboard.press("a");
  await expect(overlayCard(page)).toContainText("Attractors");
  await page.keyboard.press("a");
  await expect(overlayCard(page)).toBeHidden();
  await page.keyboard.press("Escape");
  const land = page.getByRole("combobox", { name: "Kind of land" });
  await land.selectOption("archipelago");
  await expectAddress(page, "land", "archipelago");
  await land.focus();
  await page.keyboard.press("w");
  await expect(page.locator("html")).not.toHaveAttribute("data-map-alone");
  await page.keyboard.press("Control+z");
  await expectAddress(page, "land", "island");
});

test("a key that is held lays a thing over the map, and does not take it away again", async ({ page }) => {
  await openFinished(page, LINK);
  for (let i = 0; i < 4; i++) await page.keyboard.down("o");
  await page.keyboard.up("o");
  await expect(overlayCard(page)).toContainText("Orders");
});

test("each Escape takes one thing back, the innermost first", async ({ page }) => {
  await openFinished(page, LINK);
  await openPanel(page);
  await page.keyboard.press("o");
  await expect(overlayCard(page)).toBeVisible();
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(riverCard(page)).toBeVisible();
  await page.getByRole("slider", { name: "How much sea" }).focus();
  const open = (): Promise<boolean[]> =>
    Promise.all([riverCard(page), page.locator("#panel"), overlayCard(page)].map((one) => one.isVisible()));
  expect(await open()).toEqual([true, true, true]);
  for (const left of [
    [false, true, true],
    [false, false, true],
    [false, false, false],
  ]) {
    await page.keyboard.press("Escape");
    expect(await open()).toEqual(left);
  }
});

test("Escape ends drawing, and leaves what is laid over the map; then that goes, then the map is not alone", async ({
  page,
}) => {
  // A browser that fills the screen keeps Escape for its own way out.
  await page.addInitScript(() => Reflect.deleteProperty(Element.prototype, "requestFullscreen"));
  await openFinished(page, LINK);
  await page.keyboard.press("o");
  await page.getByRole("button", { name: "Draw", exact: true }).click();
  const tools = page.getByRole("group", { name: "Drawing a land" });
  await expect(tools).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(tools).toBeHidden();
  await expect(overlayCard(page)).toBeVisible();
  await page.locator("#frame").focus();
  await page.keyboard.press("w");
  await expect(page.locator("html")).toHaveAttribute("data-map-alone");
  await page.keyboard.press("Escape");
  await expect(page.locator(".inside path")).toHaveCount(0);
  await expect(page.locator("html")).toHaveAttribute("data-map-alone");
  await page.keyboard.press("Escape");
  await expect(page.locator("html")).not.toHaveAttribute("data-map-alone");
});

/** Types with this time between two keys, wherever the focus is. The page's clock is stopped. */
async function type(page: Page, text: string, everyMs: number): Promise<void> {
  for (const key of text) {
    await page.keyboard.press(key);
    await page.clock.runFor(everyMs);
  }
}

test("no letter of a sentence that is typed with no focus is a key, and one alone is @core", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, LINK);
  await stopClock(page);
  const before = page.url();
  for (const sentence of ["draw a country", "a book, please.", "llama", "What? A word."]) {
    await type(page, sentence, 300);
    await page.clock.runFor(2000);
  }
  expect(page.url()).toBe(before);
  await expect(overlayCard(page)).toBeHidden();
  await expect(page.locator("html")).not.toHaveAttribute("data-map-alone");
  await expect(page.locator("dialog[open]")).toHaveCount(0);
  await expect(page.locator("#panel")).toBeHidden();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished");
  // Nor does a space press the button that was pressed last.
  await page.locator("#shape").focus();
  await type(page, "on the shape", 300);
  await page.clock.runFor(2000);
  await expect(page.locator("#panel")).toBeHidden();
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("a");
  await page.clock.runFor(400);
  await expect(overlayCard(page)).toBeHidden();
  await page.clock.runFor(200);
  await expect(overlayCard(page)).toContainText("Attractors");
  // The same again acts at once.
  await page.keyboard.press("a");
  await expect(overlayCard(page)).toBeHidden();
});

test("keys of a single character can be switched off for good, and all others go on @core", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, LINK);
  const open = page.getByRole("button", { name: "Help and keys" });
  const sheet = page.getByRole("dialog", { name: "Riverseed" });
  const box = sheet.getByRole("checkbox", { name: "Single letters and signs are keys" });
  await open.click();
  await expect(box).toBeChecked();
  await box.uncheck();
  await page.keyboard.press("Escape");
  await page.reload();
  await finished(page);
  await stopClock(page);
  const before = page.url();
  await page.locator("#frame").focus();
  for (const key of ["r", "o", "w", "p", "s", "l", "?", ","]) {
    await page.keyboard.press(key);
    await page.clock.runFor(600);
  }
  await page.clock.resume();
  expect(page.url()).toBe(before);
  await expect(overlayCard(page)).toBeHidden();
  await expect(page.locator("dialog[open]")).toHaveCount(0);
  await expect(page.locator("#panel")).toBeHidden();
  await page.keyboard.press(" ");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await finished(page);
  await open.click();
  await box.check();
  await page.keyboard.press("Escape");
  await page.keyboard.press("o");
  await expect(overlayCard(page)).toContainText("Orders");
});
