import { expect, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import {
  complaints,
  finished,
  openFinished,
  openSettings,
  openStopped,
  ownClock,
  recordStates,
  runUntil,
  shown,
  stopClock,
} from "./riverpage.ts";

/** The moment in its making that the line of time tells. */
function moment(page: Page): Promise<string | null> {
  return page.getByRole("slider", { name: "The making of the map" }).getAttribute("aria-valuetext");
}

/** Opens a link and lets its river grow for a second, with time to grow on: the page's clock then stands still. */
async function growSome(page: Page, link: string): Promise<void> {
  await openStopped(page, link);
  const start = await shown(page);
  await page.clock.runFor(1000);
  expect((await shown(page)).sha256).not.toBe(start.sha256);
}

test("a visitor sees a finished map, may see it grow again, and then its counts @core", async ({ page }) => {
  const said = complaints(page);
  const states = await recordStates(page);
  await openStopped(page);
  await page.clock.runFor(100);
  await expect(page.locator("#caption")).toHaveText("Growing");
  await runUntil(page, "meandering");
  await expect(page.locator("#caption")).toHaveText("Meandering");
  await page.clock.resume();
  await finished(page);
  expect(await states()).toEqual(["settling", "finished", "growing", "finished"]);
  const { summary } = pictureOf("seed=Kestrel", 16, 16);
  const counts = `${summary.mouths} rivers, ${summary.sources} sources`;
  await expect(page.getByRole("img", { name: counts })).toBeVisible();
  await expect(page.locator("#caption")).toHaveText(/Greatest river: \D+$/);
  await page.getByRole("button", { name: "Shape…" }).click();
  await page.getByText("How river-like?").click();
  await expect(page.locator(".measured")).toContainText(counts);
  expect(said).toEqual([]);
});

test("the finished river is announced once, and is the picture's alternative @core", async ({ page }) => {
  await openStopped(page, "seed=rimu&attractors=300&style=ink&labels=none");
  await expect(page.locator("#canvas")).toHaveAttribute("aria-label", /still growing/);
  await page.clock.resume();
  await finished(page);
  await expect(page.locator("#announcement")).toContainText(/^Finished: \d+ rivers?, /);
  await expect(page.locator("#canvas")).toHaveAttribute("aria-label", /^River network grown from the seed “rimu”: \d/);
});

test("the animated river ends as the one that is drawn at once @core", async ({ page }) => {
  await openStopped(page, "seed=totara&attractors=800&style=ink&labels=none");
  await page.clock.resume();
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=totara&attractors=800&style=ink&labels=none", width, height, framing).sha256);
});

test("pause holds the river, play goes on to the same end @core", async ({ page }) => {
  await growSome(page, "seed=matai&attractors=800&style=ink&labels=none");
  await page.getByRole("button", { name: "Pause" }).click();
  await page.clock.runFor(100);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  const held = await moment(page);
  const before = await shown(page);
  await page.clock.runFor(2000);
  expect(await moment(page)).toBe(held);
  expect((await shown(page)).sha256).toBe(before.sha256);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.clock.resume();
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=matai&attractors=800&style=ink&labels=none", width, height, framing).sha256);
});

test("replay grows the same river again", async ({ page }) => {
  const states = await recordStates(page);
  await ownClock(page);
  await openFinished(page, "seed=rata&attractors=300&style=ink&labels=none");
  const first = await shown(page);
  await stopClock(page);
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.clock.resume();
  await finished(page);
  expect(await shown(page)).toEqual(first);
  expect(await states()).toEqual(["settling", "finished", "growing", "finished"]);
});

test("speed goes up to instant, by keys", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, "seed=hinau&attractors=300&style=ink&labels=none");
  await openSettings(page);
  const speed = page.getByRole("slider", { name: "Speed of growth" });
  await speed.focus();
  await page.keyboard.press("End");
  await expect(speed).toHaveAttribute("aria-valuetext", "instant");
  await stopClock(page);
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  // Far less than a growth of two seconds.
  await page.clock.runFor(200);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished");
});

test("another window size shows the same river, drawn for that size", async ({ page }) => {
  await openFinished(page, "seed=tawa&attractors=500&style=ink&labels=none");
  const before = await shown(page);
  await page.setViewportSize({ width: 700, height: 900 });
  await expect.poll(async () => (await shown(page)).width).not.toBe(before.width);
  const after = await shown(page);
  expect(after.sha256).toBe(
    pictureOf("seed=tawa&attractors=500&style=ink&labels=none", after.width, after.height, after.framing).sha256,
  );
  const { x, width } = (await page.locator("#canvas").boundingBox()) ?? { x: 0, width: 0 };
  expect(Math.round(x + width) - Math.round(x)).toBe(after.width);
});

test("a hidden tab does not draw, and goes on when it is seen", async ({ page }) => {
  await growSome(page, "seed=miro&attractors=2000&style=ink&labels=none");
  const hide = (hidden: boolean) =>
    page.evaluate((value) => {
      Object.defineProperty(document, "hidden", { configurable: true, value });
      document.dispatchEvent(new Event("visibilitychange"));
    }, hidden);
  await hide(true);
  const { sha256 } = await shown(page);
  await page.clock.runFor(2000);
  expect((await shown(page)).sha256).toBe(sha256);
  await hide(false);
  await page.clock.runFor(500);
  expect((await shown(page)).sha256).not.toBe(sha256);
  await page.clock.resume();
  await finished(page);
});
