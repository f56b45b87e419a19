import { expect, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import {
  finished,
  openFinished,
  openStopped,
  ownClock,
  recordPhases,
  runUntil,
  shown,
  stopClock,
  unfold,
} from "./riverpage.ts";

const LINK = "seed=kauri&attractors=600&meander-rounds=400&lakes=0&deltas=0&style=ink&labels=none";

/** Pauses as soon as the river is in a phase; the picture that is then shown. The page's clock is stopped. */
async function paused(page: Page, phase: string): Promise<string> {
  await runUntil(page, phase);
  await page.getByRole("button", { name: "Pause" }).click();
  await page.clock.runFor(100);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  return (await shown(page)).sha256;
}

test("rivers that have grown meander before one's eyes, and come to the end that the core comes to @core", async ({
  page,
}) => {
  const phases = await recordPhases(page);
  await openStopped(page, LINK);
  const began = (await phases()).lastIndexOf("growing");
  const first = await paused(page, "meandering");
  await expect(page.locator("#caption")).toHaveText("Paused while meandering");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.clock.runFor(1000);
  const second = await paused(page, "meandering");
  expect(second).not.toBe(first);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.clock.resume();
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf(LINK, width, height, framing).sha256);
  expect(sha256).not.toBe(second);
  expect((await phases()).slice(began).filter((phase) => phase !== "shaping" && phase !== "drowning")).toEqual([
    "growing",
    "meandering",
    "finished",
  ]);
});

test("replay grows and meanders again", async ({ page }) => {
  const phases = await recordPhases(page);
  await ownClock(page);
  await openFinished(page, LINK);
  await stopClock(page);
  const began = (await phases()).length;
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await page.clock.resume();
  await finished(page);
  const again = (await phases()).slice(began).filter((phase) => phase !== "shaping" && phase !== "drowning");
  expect(again).toEqual(["growing", "meandering", "finished"]);
});

test("a change of meanders while rivers grow does not disturb them, and counts in the end", async ({ page }) => {
  await openStopped(page, "seed=kauri&attractors=3000&style=ink&labels=none");
  await paused(page, "growing");
  await unfold(page);
  await page.getByLabel("Strength, exact value").fill("0.9");
  await page.getByLabel("Strength, exact value").press("Enter");
  await page.clock.runFor(1000);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await expect(page.locator("#frame")).toHaveAttribute("data-phase", "growing");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.clock.resume();
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(
    pictureOf("seed=kauri&attractors=3000&meander-strength=0.9&style=ink&labels=none", width, height, framing).sha256,
  );
});

test("a change of meanders while rivers meander shows what comes of it", async ({ page }) => {
  await openStopped(page, LINK);
  await paused(page, "meandering");
  await unfold(page);
  await page.getByLabel("Strength, exact value").fill("0.9");
  await page.getByLabel("Strength, exact value").press("Enter");
  await page.clock.resume();
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf(`${LINK}&meander-strength=0.9`, width, height, framing).sha256);
});

test("rivers without meanders are finished when they are made", async ({ page }) => {
  await page.goto("./?seed=kauri&attractors=300&meander=none&style=ink&labels=none");
  await finished(page);
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(
    pictureOf("seed=kauri&attractors=300&meander=none&style=ink&labels=none", width, height, framing).sha256,
  );
});

test("oxbow lakes are counted in words", async ({ page }) => {
  const link =
    "seed=kauri&land=rectangle&bending=1&bending-variation=0&great-rivers=16&meander-elsewhere=1&meander-rounds=200&meander-strength=1&attractors=1000";
  const { summary } = pictureOf(link, 16, 16);
  expect(summary.oxbows).toBeGreaterThan(1);
  await openFinished(page, link);
  const counts = `Strahler order ${summary.order}, ${summary.oxbows} oxbow lakes`;
  await expect(page.getByRole("img", { name: counts })).toBeVisible();
});
