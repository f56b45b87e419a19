/** The states that the page can be in, for tests that hold in all of them. */

import { expect, type Page } from "@playwright/test";
import { finished, openPanel, unfold } from "./riverpage.ts";

/** Seeds as long as seeds may be, without a place to break: letters, wide characters, and a script that runs from right to left. */
export const LONG_SEEDS = { letters: "w".repeat(64), wide: "川".repeat(64), leftward: "נהר".repeat(22).slice(0, 64) };

/** What can be opened on the page with a finished river; each from the one before it. */
export const OPENED: Record<string, (page: Page) => Promise<void>> = {
  "at first": async () => {},
  "with the panel and all its folds open": async (page) => {
    await openPanel(page);
    await unfold(page);
  },
  "with the Save dialog open": async (page) => {
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
  },
  "with the Share dialog open": async (page) => {
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
  },
  "with the sheet of keys open": async (page) => {
    await page.getByRole("dialog").getByRole("button", { name: "Close", exact: true }).click();
    await page.keyboard.press("?");
    await expect(page.getByRole("dialog", { name: "Riverseed" })).toBeVisible();
  },
  "while a land is drawn": async (page) => {
    await page.getByRole("button", { name: "Close", exact: true }).click();
    await page.getByRole("button", { name: "Draw", exact: true }).click();
    await expect(page.getByRole("group", { name: "Drawing a land" })).toBeVisible();
  },
  "with attractors laid over a moment of growth": async (page) => {
    await page.getByRole("button", { name: "Done", exact: true }).click();
    await page.keyboard.press("a");
    const track = page.getByRole("slider", { name: "The making of the map" });
    await track.focus();
    for (const key of ["Home", "PageUp", "PageUp", "PageUp"]) await page.keyboard.press(key);
    await expect(track).toHaveAttribute("aria-valuetext", /^growth/);
    await expect(page.locator(".inside-card")).toBeVisible();
  },
  "with the map alone": async (page) => {
    await page.keyboard.press("w");
    await expect(page.locator(".bar")).toBeHidden();
  },
  "with six variants open": async (page) => {
    // One press takes back what is laid over the map, one the map alone.
    for (let i = 0; i < 2; i++) await page.keyboard.press("Escape");
    await expect(page.locator(".bar")).toBeVisible();
    await page.getByRole("button", { name: "Compare all six" }).click();
    await expect(page.locator('.six[open] .variant[data-state="finished"]')).toHaveCount(6);
  },
};

/** A link with a seed, and with mistakes that are told of. */
export function linkOfSeed(seed: string): string {
  return `${new URLSearchParams({ seed })}&attractors=300&curl=99&nonsense=${"x".repeat(40)}`;
}

/** Opens the page with an engine that cannot be fetched. */
export async function openFailed(page: Page): Promise<void> {
  await page.route("**/*.wasm", (route) => route.abort());
  await page.goto("./");
  await expect(page.getByRole("alert")).toBeVisible();
}

/** Opens the page and holds each of its files back until what came before is painted, as on a slow line, whatever the machine. */
export async function openSlowly(page: Page, link: string): Promise<void> {
  for (const files of ["**/assets/*.js", "**/*.wasm"]) {
    await page.route(files, async (route) => {
      await painted(page);
      await route.continue();
    });
  }
  await page.goto(`./?${link}`, { waitUntil: "commit" });
  await finished(page);
  // What is fetched later need not be slow, and may outlive the test.
  await page.unrouteAll({ behavior: "ignoreErrors" });
}

async function painted(page: Page): Promise<void> {
  await page.waitForFunction(() => document.readyState !== "loading");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
