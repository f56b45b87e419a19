import { expect, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import { finished, openFinished, recordPhases, shown, slowly, unfold } from "./riverpage.ts";

const LINK = "seed=kauri&attractors=600&meander-rounds=400";

async function paused(page: Page, phase: string): Promise<string> {
  await expect(page.locator("#frame")).toHaveAttribute("data-phase", phase);
  await page.getByRole("button", { name: "Pause" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  return (await shown(page)).sha256;
}

test("rivers that have grown meander before one's eyes, and come to the end that the core comes to", async ({
  page,
}) => {
  const phases = await recordPhases(page);
  const hurry = await slowly(page, "meandering");
  await page.goto(`./?${LINK}`);
  const first = await paused(page, "meandering");
  await expect(page.locator("#caption")).toContainText(/Paused while meandering ?\d+ rounds? so far/);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(async () => (await shown(page)).sha256).not.toBe(first);
  const second = await paused(page, "meandering");
  expect(second).not.toBe(first);
  await hurry();
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await finished(page);
  const { width, height, sha256 } = await shown(page);
  expect(sha256).toBe(pictureOf(LINK, width, height).sha256);
  expect(sha256).not.toBe(second);
  expect((await phases()).filter((phase) => phase !== "shaping")).toEqual(["growing", "meandering", "finished"]);
});

test("replay grows and meanders again", async ({ page }) => {
  const phases = await recordPhases(page);
  await openFinished(page, LINK);
  const began = (await phases()).length;
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await finished(page);
  const again = (await phases()).slice(began).filter((phase) => phase !== "shaping");
  expect(again).toEqual(["growing", "meandering", "finished"]);
});

test("a change of meanders while rivers grow does not disturb them, and counts in the end", async ({ page }) => {
  const hurry = await slowly(page, "growing");
  await page.goto("./?seed=kauri&attractors=3000");
  await paused(page, "growing");
  await hurry();
  await unfold(page);
  await page.getByLabel("Strength, exact value").fill("0.9");
  await page.getByLabel("Strength, exact value").press("Enter");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await expect(page.locator("#frame")).toHaveAttribute("data-phase", "growing");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await finished(page);
  const { width, height, sha256 } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=kauri&attractors=3000&meander-strength=0.9", width, height).sha256);
});

test("a change of meanders while rivers meander shows what comes of it", async ({ page }) => {
  const hurry = await slowly(page, "meandering");
  await page.goto(`./?${LINK}`);
  await paused(page, "meandering");
  await hurry();
  await unfold(page);
  await page.getByLabel("Strength, exact value").fill("0.9");
  await page.getByLabel("Strength, exact value").press("Enter");
  await finished(page);
  const { width, height, sha256 } = await shown(page);
  expect(sha256).toBe(pictureOf(`${LINK}&meander-strength=0.9`, width, height).sha256);
});

test("rivers without meanders are finished when they are made", async ({ page }) => {
  await page.goto("./?seed=kauri&attractors=300&meander=none");
  await finished(page);
  const { width, height, sha256 } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=kauri&attractors=300&meander=none", width, height).sha256);
});

test("oxbow lakes are counted in words", async ({ page }) => {
  const link = "seed=kauri&great=16&gentle=1&meander-rounds=200&meander-strength=1&attractors=1000";
  const { summary } = pictureOf(link, 16, 16);
  expect(summary.oxbows).toBeGreaterThan(1);
  await openFinished(page, link);
  await expect(page.locator("#caption")).toContainText(
    `Strahler order ${summary.order}, ${summary.oxbows} oxbow lakes`,
  );
});
