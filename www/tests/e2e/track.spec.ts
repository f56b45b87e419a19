import { createHash } from "node:crypto";
import { expect, type Page, test } from "@playwright/test";
import { momentAt, shareOf } from "../../src/apps/page/timeline/track.ts";
import type { Moment } from "../../src/apps/page-worker/protocol.ts";
import { engine, pixelsOf } from "../core.ts";
import { violations } from "./axe.ts";
import { complaints, expectPictureOfAddress, finished, openBegun, openFinished, shown } from "./riverpage.ts";
import { download } from "./saving.ts";

// A style with a relief, so that the last round is not the end.
const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=9&style=survey&labels=none";

function track(page: Page) {
  return page.getByRole("slider", { name: "The making of the map" });
}

/** Goes somewhere on the track by keys. */
async function go(page: Page, ...keys: string[]): Promise<void> {
  await expect(track(page)).toHaveAttribute("aria-disabled", "false");
  await track(page).focus();
  for (const key of keys) await page.keyboard.press(key);
}

async function expectMoment(page: Page, text: string): Promise<void> {
  await expect(track(page)).toHaveAttribute("aria-valuetext", text);
}

/** The moment that is so many tenths of the track from its beginning. */
function afterTenths(tenths: number): Moment {
  const river = new engine.River(LINK);
  while (river.advance(1000));
  const making = river.timeline()?.making() ?? { ticks: 0, rounds: 0 };
  let at = momentAt(0, making);
  for (let i = 0; i < tenths; i++) at = momentAt(shareOf(at, making) + 0.1, making);
  return at;
}

/** The picture on the page is that of a river that has been played to a moment. */
async function expectPictureOf(page: Page, { part, step }: Moment): Promise<void> {
  const { width, height, framing } = await shown(page);
  const river = new engine.River(LINK);
  river.resize(width, height);
  river.frame(new Float32Array(framing));
  const isThere = (now: Moment): boolean => now.part === part && now.step === step;
  while (!isThere(river.moment())) river.advance(1);
  const expected = createHash("sha256").update(pixelsOf(river)).digest("hex");
  river.free();
  await expect.poll(async () => (await shown(page)).sha256).toBe(expected);
}

test("a thumb that goes back and forth shows what was seen when the map grew @core", async ({ page }) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  await go(page, "Home");
  await expectMoment(page, "land");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await expectPictureOf(page, { part: "growth", step: 0 });
  await go(page, "PageUp", "PageUp", "PageUp");
  await expect(track(page)).toHaveAttribute("aria-valuetext", /^growth, \d+ %$/);
  await expectPictureOf(page, afterTenths(3));
  const before = (await shown(page)).sha256;
  await go(page, "End");
  await finished(page);
  await expectPictureOfAddress(page);
  await go(page, "Home", "PageUp", "PageUp", "PageUp");
  await expect.poll(async () => (await shown(page)).sha256).toBe(before);
  expect(said).toEqual([]);
});

test("bends are gone through round by round, by comma and full stop", async ({ page }) => {
  await openFinished(page, LINK);
  await expect(track(page)).toHaveAttribute("aria-disabled", "false");
  await page.keyboard.press(",");
  await expectMoment(page, "bends, round 9 of 9");
  await page.keyboard.press(",");
  await page.keyboard.press(",");
  await expectMoment(page, "bends, round 7 of 9");
  await expectPictureOf(page, { part: "bends", step: 7 });
  for (let i = 0; i < 3; i++) await page.keyboard.press(".");
  await finished(page);
  await expectMoment(page, "finished map");
  // In the seed box they are letters.
  await page.locator("#seed").focus();
  await page.keyboard.press(",");
  await expect(page.locator("#seed")).toHaveValue(/,/);
  await expectMoment(page, "finished map");
});

test("the thumb is dragged, and play goes on from there", async ({ page }) => {
  await openFinished(page, LINK);
  await expect(track(page)).toHaveAttribute("aria-disabled", "false");
  const box = await track(page).boundingBox();
  if (!box) throw new Error("the track has no place");
  const at = (share: number): [number, number] => [box.x + box.width * share, box.y + box.height / 2];
  await page.mouse.move(...at(0.99));
  await page.mouse.down();
  await page.mouse.move(...at(0.5), { steps: 4 });
  await page.mouse.move(...at(0.3), { steps: 4 });
  await page.mouse.up();
  await expect(track(page)).toHaveAttribute("aria-valuetext", /^growth, \d+ %$/);
  await expect(page.locator("#frame")).toHaveAttribute("data-phase", "growing");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await finished(page);
  await expectMoment(page, "finished map");
  await expectPictureOfAddress(page);
});

test("before the first end the track shows how far it is, and cannot be moved", async ({ page }) => {
  await openBegun(page, LINK);
  await expect(track(page)).toHaveAttribute("aria-disabled", "true");
  await track(page).focus();
  await page.keyboard.press("Home");
  await page.keyboard.press(".");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "settling");
});

test("a file that is saved half-way is of the finished map", async ({ page }) => {
  await openFinished(page, LINK);
  await go(page, "Home", "PageUp", "PageUp");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  expect((await download(page, "Drawing")).name).toMatch(/\.svg$/);
});

test("another map begins a track of its own", async ({ page }) => {
  await openFinished(page, LINK);
  await go(page, "Home");
  await expectMoment(page, "land");
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await finished(page);
  await expectMoment(page, "finished map");
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 390, 320]) {
    test(`axe finds nothing half-way along the track, and it fits: ${colorScheme}, ${width} wide`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 850 });
      await openFinished(page, LINK);
      await go(page, "Home", "PageUp");
      await expect(track(page)).toHaveAttribute("aria-valuetext", /growth/);
      expect(await violations(page)).toEqual([]);
      const box = await track(page).boundingBox();
      expect(box?.x).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
      expect(box?.height).toBeGreaterThanOrEqual(24);
    });
  }
}
