import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { complaints, finished, openFinished, openPanel, openStopped, openWithPanel } from "./riverpage.ts";

const LINK =
  "country=usual&seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&style=ink&labels=none";

/** A place on the greatest river, in the page's pixels: where it is shown from by keys. */
async function greatest(page: Page): Promise<{ x: number; y: number; name: string }> {
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(card(page)).toBeVisible();
  const name = (await page.locator(".river-name").textContent()) ?? "";
  const box = await page.locator(".river-pointer .spot").evaluate((spot) => {
    const { x, y, width, height } = spot.getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  });
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
  return { ...box, name };
}

function card(page: Page) {
  return page.locator(".river-card");
}

test("a river under the mouse is told by name and order, with its basin and its way to the sea; Escape hides it @core", async ({
  page,
}) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  const { x, y, name } = await greatest(page);
  await page.mouse.move(x, y);
  await expect(card(page)).toBeVisible();
  await expect(card(page)).toContainText(name);
  await expect(card(page)).toContainText(/Order \d( \(1 here\))? · [\d,.]+ km long · drains .* of the land/);
  await expect(card(page)).toContainText(/Flows into the .*sea/);
  for (const part of [".basin", ".way"])
    await expect(page.locator(`.river-pointer ${part}`)).toHaveAttribute("d", /^M.{20}/);
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
  await page.mouse.move(x + 1, y);
  await expect(card(page)).toBeVisible();
  // At sea there is none.
  await page.mouse.move(40, 450);
  await expect(card(page)).toBeHidden();
  expect(said).toEqual([]);
});

test("it goes with the map", async ({ page }) => {
  await openFinished(page, LINK);
  const { x, y } = await greatest(page);
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(card(page)).toBeVisible();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  const box = await page.locator("#map-place").boundingBox();
  const spot = await page.locator(".river-pointer .spot").boundingBox();
  expect(spot?.x ?? 0).toBeGreaterThan(box?.x ?? 0);
  expect(Math.hypot((spot?.x ?? 0) - x, (spot?.y ?? 0) - y)).toBeGreaterThan(10);
  await expect(card(page)).toBeVisible();
});

test("while the map is painted anew in another place, no line lies beside its river", async ({ page }) => {
  await openFinished(page, LINK);
  const { x, y } = await greatest(page);
  await page.mouse.move(x, y);
  await expect(card(page)).toBeVisible();
  const way = page.locator(".river-pointer .way");
  await expect(way).toBeVisible();
  const seen = await page.evaluate(async () => {
    const frame = document.querySelector<HTMLElement>("#frame");
    const lines = document.querySelector(".river-pointer");
    if (!frame || !lines) throw new Error("no map");
    const before = frame.dataset["framing"];
    document.querySelector<HTMLButtonElement>("#zoom-in")?.click();
    const seen: [isPainted: boolean, areLinesSeen: boolean][] = [];
    do {
      seen.push([frame.dataset["framing"] !== before, getComputedStyle(lines).visibility === "visible"]);
      await new Promise(requestAnimationFrame);
    } while (seen.at(-1)?.[1] === false);
    return seen;
  });
  expect(seen.length).toBeGreaterThan(1);
  for (const [isPainted, areLinesSeen] of seen) expect(isPainted || !areLinesSeen).toBe(true);
  expect(seen.at(-1)).toEqual([true, true]);
});

test("a tap shows a river, and a tap elsewhere hides it @core", async ({ browser }) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 820, height: 900 } });
  const page = await context.newPage();
  await openFinished(page, LINK);
  const { x, y, name } = await greatest(page);
  await page.touchscreen.tap(x, y);
  await expect(card(page)).toContainText(name);
  await page.touchscreen.tap(20, 450);
  await expect(card(page)).toBeHidden();
  await context.close();
});

test("keys walk through the greatest rivers, and each is announced", async ({ page }) => {
  await openFinished(page, LINK);
  await page.locator("#frame").focus();
  const names: string[] = [];
  for (const key of ["n", "n", "Shift+N"]) {
    const before = await page.locator("#frame").getAttribute("data-river");
    await page.keyboard.press(key);
    await expect.poll(() => page.locator("#frame").getAttribute("data-river")).not.toBe(before);
    names.push((await page.locator(".river-name").textContent()) ?? "");
  }
  expect(names[2]).toBe(names[0]);
  expect(names[1]).not.toBe(names[0]);
  const announcement = page.locator("#sheet > .unseen[role=status]").last();
  await expect(announcement).toContainText(names[0] ?? "none");
  await expect(announcement).toContainText("Order");
});

test("a name that has the focus in the panel shows its river", async ({ page }) => {
  await openWithPanel(page, LINK.replace("labels=none", "labels=some"));
  await page.getByRole("heading", { name: "Names" }).click();
  const field = page.getByLabel("2nd greatest river", { exact: true });
  await field.focus();
  await expect(page.locator(".river-name")).toHaveText(await field.inputValue());
  await page.getByLabel("Map", { exact: true }).and(page.locator("input")).focus();
  await expect(card(page)).toBeHidden();
});

test("of a river that grows nothing is shown", async ({ page }) => {
  await openStopped(page, LINK);
  await page.mouse.move(600, 400);
  await page.clock.runFor(200);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await expect(card(page)).toBeHidden();
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 390]) {
    test(`axe finds nothing in a card: ${colorScheme}, ${width} wide`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 850 });
      await openFinished(page, LINK);
      await page.locator("#frame").focus();
      await page.keyboard.press("n");
      await expect(card(page)).toBeVisible();
      expect(await violations(page)).toEqual([]);
      const box = await card(page).boundingBox();
      expect(box?.x).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
    });
  }
}

test("another map takes the card away", async ({ page }) => {
  await openFinished(page, LINK);
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(card(page)).toBeVisible();
  await openPanel(page);
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await finished(page);
  await expect(card(page)).toBeHidden();
});
