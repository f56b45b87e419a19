/** How fast rivers grow, on a page whose clock is stopped: there growth is a matter of frames, and work takes no time. */

import type { Page } from "@playwright/test";
import type { RiverSeed } from "../../../src/apps/widget/element.ts";
import { ownClock, stopClock } from "../riverpage.ts";
import { expect, type Host, test } from "./hosts.ts";
import { heard, listen, post } from "./post.ts";

const RECIPE = "seed=rimu&style=ink&labels=none&attractors=2000";

/** Opens rivers side by side, and stops the clock when they are finished. */
async function openStopped(page: Page, blog: Host, ...attributes: string[]): Promise<void> {
  const events = await listen(page);
  await ownClock(page);
  const rivers = attributes.map((some) => `<river-seed recipe="${RECIPE}" ${some}></river-seed>`);
  const columns = `display: grid; grid-template-columns: repeat(${rivers.length}, 1fr)`;
  blog.answer("/", { body: post(`<div style="${columns}">${rivers.join("")}</div>`) });
  await page.goto(blog.origin);
  await heard(events, "complete", rivers.length);
  await stopClock(page);
}

/** Lets some time pass; how far each river is then. */
async function progressAfter(page: Page, ms: number): Promise<number[]> {
  await page.clock.runFor(ms);
  return page.locator("river-seed").evaluateAll((all) => (all as RiverSeed[]).map(({ progress }) => progress));
}

test("rivers grow as fast as they are asked to, and as usual if they are asked nonsense @core", async ({
  page,
  blog,
}) => {
  await openStopped(page, blog, "still", 'still speed="0.25"', 'still speed="4"', 'still speed="fast"');
  await page.locator("river-seed").evaluateAll((all) => {
    for (const river of all as RiverSeed[]) river.restart();
  });
  const [usual = 0, slow = 0, fast = 0, nonsense] = await progressAfter(page, 1000);
  // Half of the way is growth, and takes two seconds.
  expect(slow).toBeGreaterThan(0);
  expect(slow).toBeLessThan(usual / 2);
  expect(usual).toBeLessThan(0.5);
  expect(fast).toBeGreaterThan(0.5);
  expect(nonsense).toBe(usual);
});

test("another speed counts at once, on the way", async ({ page, blog }) => {
  await openStopped(page, blog, 'speed="8"');
  const river = page.locator("river-seed");
  await river.evaluate((river: RiverSeed) => {
    river.speed = 0.25;
    river.restart();
  });
  await expect(river).toHaveAttribute("speed", "0.25");
  const [early] = await progressAfter(page, 500);
  expect(early).toBeLessThan(0.2);
  await river.evaluate((river) => river.setAttribute("speed", "8"));
  const [late] = await progressAfter(page, 500);
  expect(late).toBeGreaterThan(0.5);
});
