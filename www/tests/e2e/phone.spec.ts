import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import {
  address,
  complaints,
  expectAddress,
  expectPictureOfAddress,
  finished,
  fixChance,
  openFinished,
  openPanel,
  openSettings,
} from "./riverpage.ts";
import { core } from "./tiers.ts";

const LINK =
  "country=usual&seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&aspect=0.5&style=ink&labels=none";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/** Taps one spot with one finger. The events carry their own times, so that taps are as fast as a finger's on any machine. */
async function taps(page: Page, tapCount: number, x = 195, y = 320): Promise<void> {
  const line = await page.context().newCDPSession(page);
  const first = Date.now() / 1000 - 0.3;
  for (let tap = 0; tap < tapCount; tap++) {
    const timestamp = first + tap * 0.15;
    await line.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }], timestamp });
    await line.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [], timestamp: timestamp + 0.03 });
  }
  await line.detach();
}

/** What of the browser's full screen was asked for, and whether it has any. */
async function withScreen(page: Page, has: boolean): Promise<() => Promise<string[]>> {
  await page.addInitScript((has) => {
    const asked: string[] = [];
    Object.assign(globalThis, { asked });
    let full: Element | null = null;
    Object.defineProperty(Document.prototype, "fullscreenElement", { get: () => full });
    Element.prototype.requestFullscreen = async function () {
      asked.push("enter");
      full = this;
    };
    Document.prototype.exitFullscreen = async () => {
      asked.push("leave");
      full = null;
    };
    if (!has) Reflect.deleteProperty(Element.prototype, "requestFullscreen");
  }, has);
  return () => page.evaluate(() => (globalThis as unknown as { asked: string[] }).asked);
}

for (const has of [true, false]) {
  test(`two taps leave the map alone, ${has ? "over the whole screen" : "in a browser without full screen"}, and two more bring all back${core(has)}`, async ({
    page,
  }) => {
    const said = complaints(page);
    const asked = await withScreen(page, has);
    await openFinished(page, LINK);
    const [bar, place] = [page.locator(".bar"), page.locator("#map-place")];
    const small = await place.boundingBox();
    await taps(page, 2);
    await expect(bar).toBeHidden();
    await expect(page.locator("#styles")).toBeHidden();
    await expect.poll(async () => (await place.boundingBox())?.height).toBeGreaterThan(small?.height ?? 0);
    expect(await asked()).toEqual(has ? ["enter"] : []);
    await expectPictureOfAddress(page);
    expect(await violations(page)).toEqual([]);
    await taps(page, 2);
    await expect(bar).toBeVisible();
    expect(await asked()).toEqual(has ? ["enter", "leave"] : []);
    await expect.poll(() => place.boundingBox()).toEqual(small);
    // There is a button for those who do not know, and keys.
    await taps(page, 2);
    await page.getByRole("button", { name: "Back from the map alone" }).tap();
    await expect(bar).toBeVisible();
    await page.keyboard.press("w");
    await expect(bar).toBeHidden();
    // Of what was tapped the card goes first.
    for (let i = 0; i < 2; i++) await page.keyboard.press("Escape");
    await expect(bar).toBeVisible();
    expect(said).toEqual([]);
  });
}

test("the browser's own way out of full screen brings all back, too", async ({ page }) => {
  await withScreen(page, true);
  await openFinished(page, LINK);
  await taps(page, 2);
  await expect(page.locator(".bar")).toBeHidden();
  await page.evaluate(async () => {
    await document.exitFullscreen();
    document.dispatchEvent(new Event("fullscreenchange"));
  });
  await expect(page.locator(".bar")).toBeVisible();
});

test("one tap is a river's, and a pinch zooms @core", async ({ page }) => {
  const asked = await withScreen(page, true);
  await openFinished(page, LINK);
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(page.locator(".river-card")).toBeVisible();
  const spot = await page.locator(".river-pointer .spot").boundingBox();
  await page.keyboard.press("Escape");
  await expect(page.locator(".river-card")).toBeHidden();
  await taps(page, 1, (spot?.x ?? 0) + (spot?.width ?? 0) / 2, (spot?.y ?? 0) + (spot?.height ?? 0) / 2);
  await expect(page.locator(".river-card")).toBeVisible();
  // The card may lie where the fingers are.
  await page.keyboard.press("Escape");
  await expect(page.locator(".river-card")).toBeHidden();
  const before = await page.locator("#map-place").boundingBox();
  const line = await page.context().newCDPSession(page);
  await line.send("Input.synthesizePinchGesture", { x: 195, y: 320, scaleFactor: 2, gestureSourceType: "touch" });
  await expect
    .poll(async () => (await page.locator("#map-place").boundingBox())?.width)
    .toBeGreaterThan(1.5 * (before?.width ?? 0));
  expect(await asked()).toEqual([]);
  await expect(page.locator(".bar")).toBeVisible();
});

test("the speed of growth is in the panel, and shown in words", async ({ page }) => {
  await openFinished(page, LINK);
  await openSettings(page);
  const speed = page.getByRole("slider", { name: "Speed of growth" });
  for (const name of ["2×", "4×", "8×", "instant"]) {
    await speed.press("ArrowRight");
    await expect(speed).toHaveAttribute("aria-valuetext", name);
    await expect(page.locator("#speed-shown")).toHaveText(name);
  }
  await speed.press("Home");
  await expect(speed).toHaveAttribute("aria-valuetext", "¼×");
});

for (const [chosen, thrown] of [
  ["", "0.75"],
  ["&aspect=2", "2"],
] as const)
  test(`the dice choose a shape for the screen, unless somebody chose one: ${chosen || "the default"}`, async ({
    page,
  }) => {
    await fixChance(page);
    await openFinished(page, `seed=kauri&attractors=300&style=ink&labels=none${chosen}`);
    await page.getByRole("button", { name: "A new seed by chance" }).tap();
    await expect.poll(() => address(page).get("seed")).not.toBe("kauri");
    await expectAddress(page, "aspect", thrown);
    await page.setViewportSize({ width: 1440, height: 900 });
    await finished(page);
    await page.getByRole("button", { name: "A new seed by chance" }).click();
    await expectAddress(page, "aspect", chosen === "" ? null : thrown);
  });

test("a link from a wide window shows its land as large as the phone allows, and all of the map when asked @core", async ({
  page,
}) => {
  const said = complaints(page);
  await openFinished(page, "country=usual&seed=kauri&attractors=300");
  const width = async (): Promise<number> => (await page.locator("#map-place").boundingBox())?.width ?? 0;
  // The land's sides are those of the window, and the sea's are out of sight.
  await expect.poll(width).toBeGreaterThan(400);
  expect(await width()).toBeLessThan(900);
  await expectPictureOfAddress(page);
  await page.getByRole("button", { name: "Show all of the map" }).click();
  await expect.poll(width).toBeLessThan(390);
  // Another country begins as a whole.
  await page.getByRole("button", { name: "Zoom in" }).click();
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await finished(page);
  await expect.poll(width).toBeLessThan(390);
  expect(said).toEqual([]);
});

test("a map in the shape of the phone is shown whole, and so is one of land alone @core", async ({ page }) => {
  for (const link of [LINK, "land=rectangle&attractors=300"]) {
    await openFinished(page, link);
    await expect(page.locator("#frame")).not.toHaveAttribute("data-zoomed");
  }
});

test("all is reset in the shape of the phone, if there is anything to reset", async ({ page }) => {
  await openFinished(page);
  await openPanel(page);
  const reset = page.getByRole("button", { name: "Reset all" });
  await expect(reset).toBeHidden();
  await page.getByRole("slider", { name: "How wild a coast" }).press("Home");
  await expectAddress(page, "roughness", "0");
  await reset.click();
  await expectAddress(page, "roughness", null);
  expect(address(page).get("aspect")).toBe("0.75");
  await expect(reset).toBeHidden();
});
