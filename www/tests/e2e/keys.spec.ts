/** Keys of the whole page: where they mean something else, and what Escape takes back. */

import { expect, type Page, test } from "@playwright/test";
import { address, expectAddress, finished, openFinished, openPanel } from "./riverpage.ts";

const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5";

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
  await page.locator("#speed").focus();
  await page.keyboard.press("a");
  await expect(overlayCard(page)).toContainText("Attractors");
  await page.keyboard.press("a");
  await expect(overlayCard(page)).toBeHidden();
  const land = page.getByRole("combobox", { name: "Kind of land" });
  await land.selectOption("archipelago");
  await expectAddress(page, "land", "archipelago");
  await land.focus();
  await page.keyboard.press("w");
  await expect(page.locator("html")).not.toHaveAttribute("data-map-alone");
  await page.keyboard.press("Control+z");
  await expectAddress(page, "land", null);
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
  await page.locator("#exact-sea").focus();
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
