import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { complaints, finished, openFinished, openFold } from "./riverpage.ts";

const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&style=ink&labels=none";
const KEYS = { a: "attractors", t: "sources", o: "orders", b: "basins", d: "flow", f: "held", x: "captures" };

function card(page: Page) {
  return page.locator(".inside-card");
}

test("each key lays something over the map, with a sentence, and takes it away @core", async ({ page }) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  for (const [key, name] of Object.entries(KEYS)) {
    await page.keyboard.press(key);
    await expect(page.locator(`.inside[data-look="${name}"] g path`).first()).toHaveAttribute("d", /^M.{5}/);
    await expect(card(page)).toHaveText(/\w.*\.$|streams?$/);
    await page.keyboard.press(key);
    await expect(page.locator(".inside path")).toHaveCount(0);
    await expect(card(page)).toBeHidden();
  }
  expect(said).toEqual([]);
});

test("on a map that is not finished an overlay of finished maps says so, and comes when it is @core", async ({
  page,
}) => {
  await openFinished(page, LINK);
  for (let i = 0; i < 3; i++) await page.keyboard.press(",");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  for (const [key, name] of [
    ["o", "Orders"],
    ["b", "Basins"],
  ] as const) {
    await page.keyboard.press(key);
    await expect(card(page)).toContainText(`${name}This is known once the map is finished`);
    await expect(page.locator(".inside path")).toHaveCount(0);
  }
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect(page.locator('.inside[data-look="basins"] g path').first()).toBeAttached();
  await expect(card(page)).not.toContainText("finished");
});

test("the legend of orders counts streams as the picture's alternative counts sources", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("o");
  const sources = /([\d,]+) sources/.exec((await page.locator("#canvas").getAttribute("aria-label")) ?? "")?.[1];
  await expect(card(page)).toContainText(`Order 1: ${sources} streams`);
});

test("buttons in the panel do the same, one at a time, and Escape takes it away", async ({ page }) => {
  await openFinished(page, LINK);
  await openFold(page, "For the curious");
  const orders = page.getByRole("button", { name: "Orders" });
  const basins = page.getByRole("button", { name: "Basins", exact: true }).and(page.locator(".inside-buttons *"));
  await orders.click();
  await expect(orders).toHaveAttribute("aria-pressed", "true");
  await basins.click();
  await expect(orders).toHaveAttribute("aria-pressed", "false");
  await expect(basins).toHaveAttribute("aria-pressed", "true");
  await expect(card(page)).toContainText("Basins");
  await page.locator("#frame").focus();
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
  await expect(basins).toHaveAttribute("aria-pressed", "false");
});

test("no letter that is typed is a key", async ({ page }) => {
  await openFinished(page, LINK);
  await page.locator("#seed").focus();
  await page.keyboard.type("ot");
  await expect(page.locator("#seed")).toHaveValue(/ot$/);
  await finished(page);
  await expect(card(page)).toBeHidden();
});

test("it is laid over the next map, too, and a Brownian tree has no attractors", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("o");
  await expect(card(page)).toBeVisible();
  const before = await page.locator('.inside [data-kind="1"] path').getAttribute("d");
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await finished(page);
  await expect.poll(() => page.locator('.inside [data-kind="1"] path').getAttribute("d")).not.toBe(before);
  await page.goto(`./?${LINK.replace("drainage", "brownian")}&sensitivity=40`);
  await finished(page);
  await openFold(page, "For the curious");
  for (const name of ["Attractors or parcels", "Reach and kill", "Captured streams"]) {
    await expect(page.getByRole("button", { name })).toBeDisabled();
    await expect(page.getByRole("button", { name })).toHaveAttribute("title", /has none/);
  }
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 390]) {
    test(`axe finds nothing with an overlay, a card and their buttons: ${colorScheme}, ${width} wide`, async ({
      page,
    }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 850 });
      await openFinished(page, LINK);
      await page.keyboard.press("o");
      await expect(card(page)).toBeVisible();
      await page.locator("#frame").focus();
      await page.keyboard.press("n");
      await expect(page.locator(".river-card")).toBeVisible();
      await openFold(page, "For the curious");
      expect(await violations(page)).toEqual([]);
      const box = await card(page).boundingBox();
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
    });
  }
}
