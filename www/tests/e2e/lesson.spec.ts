/** The lesson of docs/for/teachers.md, step by step as it stands there. */

import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import { finished, openFinished } from "./riverpage.ts";

const lesson = readFileSync(new URL("../../../docs/for/teachers.md", import.meta.url), "utf8");
const LINK = /riverseed\/\?(\S+)/.exec(lesson)?.[1] ?? "";

/** Drags the thumb to a share of the blue part of the track, and returns what is said of the moment. */
async function stopAt(page: Page, share: number): Promise<string> {
  const track = page.getByRole("slider", { name: "The making of the map" });
  const blue = await page.locator('.track-part[data-part="growth"]').boundingBox();
  const bar = await track.boundingBox();
  if (!blue || !bar) throw new Error("there is no track");
  await page.mouse.click(blue.x + share * (blue.width - 1), bar.y + bar.height / 2);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  const word = `growth, ${Math.round(share * 100)} %`;
  await expect.poll(() => track.getAttribute("aria-valuetext")).toMatch(/^growth, \d+ %$/);
  return word;
}

/** The red of the pale water between two banks is 221, that of paper 246. */
const PAPER = 232;

/** Finds the pixels that are of a river: of a bank, or of the water between two banks. */
async function rivers(page: Page): Promise<boolean[]> {
  return await page.locator("#canvas").evaluate(async (shown: HTMLCanvasElement, paper) => {
    const read = (): Uint8ClampedArray => {
      const { width, height } = shown;
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context?.drawImage(shown, 0, 0);
      return context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
    };
    let last = read();
    for (;;) {
      for (let i = 0; i < 6; i++) await new Promise(requestAnimationFrame);
      const next = read();
      if (next.every((value, i) => value === last[i])) break;
      last = next;
    }
    return Array.from({ length: last.length / 4 }, (_, i) => (last[4 * i] ?? 255) < paper);
  }, PAPER);
}

/** Counts the pixels of streams that are gone at a second stop. */
function gone(first: readonly boolean[], second: readonly boolean[]): number {
  return first.filter((isRiver, i) => isRiver && !second[i]).length;
}

test("in the last quarter of the blue part streams are captured, and before that none is", async ({ page }) => {
  expect(lesson).toContain("in the last quarter of the blue part");
  await openFinished(page, LINK);
  const stops: boolean[][] = [];
  for (const share of [0.25, 0.5, 0.75, 1]) {
    await stopAt(page, share);
    stops.push(await rivers(page));
  }
  const [quarter = [], half = [], third = [], end = []] = stops;
  expect(gone(quarter, half)).toBe(0);
  expect(gone(half, third)).toBe(0);
  expect(gone(third, end)).toBeGreaterThan(500);
});

test("nothing lies over the springs that a class is to count", async ({ page }) => {
  await openFinished(page, LINK);
  await expect(page.getByRole("img", { name: /sources/ })).toBeVisible();
  await expect(page.locator("#welcome")).toBeHidden();
  // Orders come at a press of O, and the next great river at one of N, though nobody has clicked the map.
  await page.keyboard.press("n");
  await expect(page.locator("#frame")).toHaveAttribute("data-river", /\d/);
  await expect(page.locator("#frame")).toBeFocused();
  await finished(page);
});
