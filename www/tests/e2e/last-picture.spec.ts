/** The last picture, which no unfinished map wipes away. */

import { expect, type Page, test } from "@playwright/test";
import {
  beforehand,
  expectPictureOfAddress,
  finished,
  fixChance,
  onDay,
  openBegun,
  openFinished,
  ownClock,
  stopClock,
} from "./riverpage.ts";

const LINK = "seed=kauri&attractors=600";
const FRAME_MS = 16;
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

/** Lets the stopped clock run until the next map has begun, and no further: a frame without a clock has time for much. */
async function begun(page: Page): Promise<void> {
  const state = () => page.locator("#frame").getAttribute("data-state");
  while ((await state()) !== "settling") await page.clock.runFor(FRAME_MS);
}

/** Has nothing grow, as in a hidden tab, or lets it grow again. */
async function hold(page: Page, isHeld: boolean): Promise<void> {
  await page.evaluate((isHeld) => {
    Object.defineProperty(document, "hidden", { configurable: true, value: isHeld });
    document.dispatchEvent(new Event("visibilitychange"));
  }, isHeld);
}

test("however long the next map takes, the last one stays, and a line says how far it is @core", async ({ page }) => {
  await openStill(page);
  await throwDice(page);
  await begun(page);
  await hold(page, true);
  await page.clock.runFor(60_000);
  await expect(last(page)).toBeVisible();
  await expect(last(page)).toHaveCSS("opacity", "1");
  await expect(page.locator("#caption")).toHaveText(/^(Growing|Drowning|Meandering|Raising)/);
  await hold(page, false);
  await page.clock.resume();
  await finished(page);
  await expect(last(page)).toHaveCount(0);
  await expectPictureOfAddress(page);
});

test("whoever moves the map meanwhile moves the last one, and finds the next where it was moved to", async ({
  page,
}) => {
  await openStill(page);
  await throwDice(page);
  await page.getByRole("button", { name: "Zoom in" }).click();
  await expect(last(page)).toBeVisible();
  const scale = await last(page).evaluate((canvas) => new DOMMatrix(getComputedStyle(canvas).transform).a);
  expect(scale).toBeGreaterThan(1.1);
  await page.clock.resume();
  await finished(page);
  await expect(last(page)).toHaveCount(0);
  await expectPictureOfAddress(page);
});

test("whoever stops the growth of the next map sees how far it is", async ({ page }) => {
  await openStill(page);
  await throwDice(page);
  await begun(page);
  await page.getByRole("button", { name: "Pause" }).click();
  await page.clock.runFor(FRAME_MS);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await expect(last(page)).toHaveCount(0);
});

const isOverPoster = (page: Page): Promise<boolean> =>
  page.locator("#canvas").evaluate((canvas) => getComputedStyle(canvas).opacity !== "0");

test("the poster stays until the first map is finished, however long that takes @core", async ({ page }) => {
  await openBegun(page);
  await expect(page.locator(".poster img")).toBeVisible();
  await hold(page, true);
  await page.clock.runFor(60_000);
  expect(await isOverPoster(page)).toBe(false);
  await hold(page, false);
  // Step by step: no state but the last may show the canvas.
  const state = () => page.locator("#frame").getAttribute("data-state");
  while ((await state()) !== "finished") {
    expect(await isOverPoster(page)).toBe(false);
    await page.clock.runFor(FRAME_MS);
  }
  await page.clock.resume();
  await expect.poll(() => isOverPoster(page)).toBe(true);
  await expectPictureOfAddress(page);
});

test("the poster stays while a worker's word of the finished map is on its way", async ({ page }) => {
  await beforehand(
    page,
    () => {
      if (!("DedicatedWorkerGlobalScope" in globalThis)) return;
      const post = globalThis.postMessage;
      const held: unknown[] = [];
      let isHeld = true;
      globalThis.postMessage = (message: { state?: string }) => {
        if (isHeld && (held.length > 0 || message.state === "finished")) held.push(message);
        else post(message);
      };
      new BroadcastChannel("release").onmessage = () => {
        isHeld = false;
        for (const message of held) post(message);
      };
      new BroadcastChannel("held").onmessage = () => new BroadcastChannel("holds").postMessage(held.length > 0);
    },
    undefined,
  );
  await onDay(page);
  await page.goto("./");
  const holdsBack = () =>
    page.evaluate(() => {
      const told = new Promise<boolean>((done) => {
        new BroadcastChannel("holds").onmessage = ({ data }) => done(data);
      });
      new BroadcastChannel("held").postMessage("");
      return told;
    });
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "settling");
  await expect.poll(holdsBack).toBe(true);
  expect(await isOverPoster(page)).toBe(false);
  await page.evaluate(() => new BroadcastChannel("release").postMessage(""));
  await finished(page);
  await expect.poll(() => isOverPoster(page)).toBe(true);
});

test("whoever moves the map before it is there moves the poster", async ({ page }) => {
  await openBegun(page);
  const poster = page.locator(".poster img");
  const before = await poster.boundingBox();
  await page.getByRole("button", { name: "Zoom in" }).click();
  const after = await poster.boundingBox();
  expect((after?.width ?? 0) / (before?.width ?? 1)).toBeGreaterThan(1.1);
  expect(await isOverPoster(page)).toBe(false);
  await page.clock.resume();
  await finished(page);
  await expectPictureOfAddress(page);
});

test("a visit with a link shows its land at once, not an empty sea @core", async ({ page }) => {
  // No step has been made yet.
  await openBegun(page, "seed=rimu&land=island");
  const colours = await page.locator("#canvas").evaluate((canvas: HTMLCanvasElement) => {
    const { width, height } = canvas;
    const pixels = canvas.getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    const at = (x: number, y: number) => Array.from(pixels.slice(4 * (y * width + x), 4 * (y * width + x) + 3));
    return { sea: at(0, 0), land: at(Math.floor(width / 2), Math.floor(height / 2)) };
  });
  // Blue water, and earth.
  expect(colours.sea[2]).toBeGreaterThan(colours.sea[0] ?? 0);
  expect(colours.land[0]).toBeGreaterThan(colours.land[2] ?? 0);
  await expect(page.getByText("Preparing the rivers…")).toBeHidden();
});
