import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { pixelsOf } from "./pixels.ts";
import {
  address,
  complaints,
  expectAddress,
  expectPictureOfAddress,
  finished,
  openFinished,
  openPanel,
} from "./riverpage.ts";

const LINK = "seed=kauri&land=island&attractors=800&meander-rounds=5&style=ink&labels=none";

function sheet(page: Page) {
  return page.getByRole("dialog", { name: "Variations" });
}

function neighbours(page: Page) {
  return sheet(page).locator(".neighbour:not([aria-current])");
}

async function allDrawn(page: Page): Promise<void> {
  await expect(sheet(page).getByRole("status")).toHaveText("All are drawn.");
}

async function openVariations(page: Page): Promise<void> {
  await openPanel(page);
  await page.getByRole("button", { name: "Variations…" }).click();
  await expect(sheet(page)).toBeVisible();
}

function pictures(page: Page): Promise<string[]> {
  return sheet(page)
    .locator("canvas")
    .evaluateAll((all) => all.map((canvas) => (canvas as HTMLCanvasElement).toDataURL()));
}

test("the map is seen among eight neighbours, each of another kind; one that is pressed becomes the map, in one step @core", async ({
  page,
}) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  await openVariations(page);
  await expect(sheet(page).locator(".neighbour")).toHaveCount(9);
  await expect(sheet(page).locator(".neighbour").nth(4)).toHaveText("This map");
  await expect(sheet(page).locator(".neighbour").nth(4)).toHaveAttribute("aria-current", "true");
  await allDrawn(page);
  expect(new Set(await pictures(page)).size).toBe(9);
  const before = page.url();
  const entries = await page.evaluate(() => history.length);
  const one = neighbours(page).first();
  await expect(one).toHaveAccessibleName(/^[a-z ]+(, [a-z ]+)?$/);
  const sha256 = (await pixelsOf(one.locator("canvas"))).sha256;
  await one.click();
  await expect(sheet(page)).toBeHidden();
  await expect.poll(() => page.url()).not.toBe(before);
  for (const [key, value] of [
    ["seed", "kauri"],
    ["style", "ink"],
  ] as const)
    await expectAddress(page, key, value);
  await expectPictureOfAddress(page);
  expect(await page.evaluate(() => history.length)).toBe(entries + 1);
  // It is the map that was promised: in the middle now.
  await openVariations(page);
  await allDrawn(page);
  const middle = sheet(page).locator('[aria-current="true"] canvas');
  expect((await pixelsOf(middle)).sha256).toBe(sha256);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect.poll(() => page.url()).toBe(before);
  expect(said).toEqual([]);
});

test("others are asked for again and again, and are the same at every visit", async ({ page }) => {
  await openFinished(page, LINK);
  const words = async (): Promise<string[]> => neighbours(page).allTextContents();
  const seen: string[][] = [];
  for (const _ of ["first visit", "second"]) {
    await openVariations(page);
    const others = sheet(page).getByRole("button", { name: "Show others" });
    const rounds = [await words()];
    for (let i = 0; i < 2; i++) {
      await others.click();
      await expect(others).toBeFocused();
      rounds.push(await words());
    }
    seen.push(rounds.map(String));
    // However fast that was, this map is drawn among them.
    await expect(sheet(page).locator('[aria-current="true"]')).toHaveAttribute("data-state", "drawn");
    await sheet(page).getByRole("button", { name: "Back to the map" }).click();
    await page.reload();
    await finished(page);
  }
  expect(new Set(seen[0]).size).toBe(3);
  expect(seen[1]).toEqual(seen[0]);
});

test("what has a padlock stays; where all is kept, there is nothing to choose, and a sentence says why", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await openPanel(page);
  await page.getByRole("button", { name: "Keep How much sea" }).click();
  await openVariations(page);
  for (const words of await neighbours(page).allTextContents()) expect(words).not.toContain("sea");
  await page.keyboard.press("Escape");
  const open = page.locator('.keep:not([aria-pressed="true"])');
  while ((await open.count()) > 0) await open.first().click();
  await openVariations(page);
  await expect(sheet(page).locator(".neighbour")).toHaveCount(1);
  await expect(sheet(page).getByRole("status")).toContainText("All that could vary is locked");
  await expect(sheet(page).getByRole("button", { name: "Show others" })).toBeDisabled();
});

test("by keyboard alone a variation is found and taken", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("v");
  await expect(sheet(page)).toBeVisible();
  await sheet(page).getByRole("button", { name: "Back to the map" }).focus();
  await page.keyboard.press("Tab");
  await expect(neighbours(page).first()).toBeFocused();
  const before = page.url();
  await page.keyboard.press("Enter");
  await expect(sheet(page)).toBeHidden();
  await expect.poll(() => page.url()).not.toBe(before);
  expect(address(page).get("seed")).toBe("kauri");
});

for (const [width, height, look] of [
  [1440, 900, "light"],
  [390, 844, "dark"],
  [320, 568, "forced colours"],
] as const)
  test(`nine are in sight, three by three, and axe finds nothing: ${width} by ${height}, ${look}`, async ({ page }) => {
    await page.emulateMedia({
      colorScheme: look === "dark" ? "dark" : "light",
      forcedColors: look === "forced colours" ? "active" : "none",
    });
    await page.setViewportSize({ width, height });
    await openFinished(page, LINK);
    await openVariations(page);
    await allDrawn(page);
    expect(await violations(page)).toEqual([]);
    expect(await sheet(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBe(0);
    for (const one of await sheet(page).locator(".neighbour").all())
      await expect(one.locator("canvas")).toBeInViewport({ ratio: 1 });
    const tops = await sheet(page)
      .locator(".neighbour")
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
    expect(new Set(tops).size).toBe(3);
  });
