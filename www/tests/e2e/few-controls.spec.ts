/** How many controls the page has in sight: few at rest, and not many more with the panel. */

import { expect, type Page, test } from "@playwright/test";
import { openFinished, openWithPanel } from "./riverpage.ts";

const MOST_AT_REST = 20;
/** With the padlock of the country. */
const MOST_WITH_PANEL = 46;

/** Everything on the page that can have the focus and is seen, whether it can be used or not; but for the map itself. */
function controlsIn(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const all = document.querySelectorAll("button, a[href], input, select, summary, textarea, [tabindex]:not(#frame)");
    const seen = [...all].filter(
      (one) => one.checkVisibility({ visibilityProperty: true }) && one.getClientRects().length > 0,
    );
    return seen.map((one) => one.id || one.getAttribute("aria-label") || one.textContent || one.tagName);
  });
}

for (const [width, height] of [
  [1440, 900],
  [390, 844],
] as const)
  test(`at rest few controls are in sight: ${width} by ${height} @core`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page);
    const controls = await controlsIn(page);
    expect(controls.length, controls.join("\n")).toBeLessThanOrEqual(MOST_AT_REST);
    for (const one of ["seed", "dice", "shape", "draw", "play", "send", "download", "share", "zoom-in", "help"])
      expect(controls).toContain(one);
  });

for (const [width, height] of [
  [1440, 900],
  [390, 844],
] as const)
  test(`the panel opens with few more controls: ${width} by ${height} @core`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openWithPanel(page);
    const controls = await controlsIn(page);
    expect(controls.length, controls.join("\n")).toBeLessThanOrEqual(MOST_WITH_PANEL);
    await expect(page.locator(".front .keep")).toHaveCount(7);
  });
