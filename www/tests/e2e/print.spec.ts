import { expect, type Page, test } from "@playwright/test";
import { type DecodedPng, decode } from "fast-png";
import { openFinished } from "./riverpage.ts";
import { LONG_SEEDS, OPENED } from "./states.ts";
import { core } from "./tiers.ts";

for (const colorScheme of ["light", "dark"] as const) {
  for (const [width, height] of [
    [718, 1047],
    [1047, 718],
  ] as const) {
    test(`paper shows the map, its title and its caption, and nothing else: ${colorScheme}, ${width} by ${height}${core(colorScheme === "light" && width < height)}`, async ({
      page,
    }) => {
      // A window that fills the screen could not be made as wide as paper; some browsers have no such thing.
      await page.addInitScript(() => Reflect.deleteProperty(Element.prototype, "requestFullscreen"));
      await page.setViewportSize({ width: 1280, height: 800 });
      await openFinished(page, `seed=${LONG_SEEDS.letters}&attractors=300&depth=3`);
      // On the screen it takes the title's place.
      await expect(page.locator("#welcome")).toBeVisible();
      for (const [state, open] of Object.entries(OPENED)) {
        await page.emulateMedia({ media: "screen", colorScheme });
        await page.setViewportSize({ width: 1280, height: 800 });
        await open(page);
        await page.emulateMedia({ media: "print", colorScheme });
        await page.setViewportSize({ width, height });
        const shown = await page.evaluate(() => {
          const leaves = [...document.querySelectorAll("body *")].filter(
            (element) =>
              element.childElementCount === 0 &&
              element.checkVisibility({ visibilityProperty: true }) &&
              element.getClientRects().length > 0 &&
              getComputedStyle(element).clipPath === "none",
          );
          return [...new Set(leaves.map((leaf) => leaf.closest("[id]")?.id))];
        });
        expect(shown.sort(), state).toEqual(["canvas", "caption", "title"]);
        const frame = await page.locator("#frame").boundingBox();
        const caption = await page.locator("#caption").boundingBox();
        if (!frame || !caption) throw new Error("nothing to print");
        expect(frame.x).toBeGreaterThanOrEqual(0);
        expect(frame.x + frame.width).toBeLessThanOrEqual(width);
        expect(frame.width / frame.height).toBeCloseTo(1.6, 1);
        expect(caption.y).toBeGreaterThanOrEqual(frame.y + frame.height);
        expect(caption.y + caption.height, state).toBeLessThanOrEqual(height);
      }
      expect(
        (await page.pdf({ format: "A4", landscape: width > height })).toString("latin1").match(/\/Type \/Page\b/g),
      ).toHaveLength(1);
    });
  }
}

test("paper shows the whole map though a part of it is on the screen, with no sea around it", async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 });
  await openFinished(page, "seed=kauri&attractors=300&land=island&style=atlas&labels=none&aspect=1.25");
  await page.emulateMedia({ media: "print" });
  const whole = await pixelsIn(page);
  await page.emulateMedia({ media: "screen" });
  for (let i = 0; i < 4; i++) await page.getByRole("button", { name: "Zoom in" }).click();
  await expect(page.locator("#frame")).not.toHaveAttribute("data-moving");
  await page.emulateMedia({ media: "print" });
  const zoomed = await pixelsIn(page);
  expect(zoomed.width / zoomed.height).toBeCloseTo(1.25, 1);
  expect([zoomed.width, zoomed.height]).toEqual([whole.width, whole.height]);
  // The same map, but for how it is scaled to the page.
  const apart = [...whole.data].reduce((sum, value, i) => sum + Math.abs(value - (zoomed.data[i] ?? 0)), 0);
  expect(apart / whole.data.length).toBeLessThan(4);
  const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  expect(background).toBe("rgb(255, 255, 255)");
});

/** The map as it is on paper. */
async function pixelsIn(page: Page): Promise<DecodedPng> {
  return decode(await page.locator("#frame").screenshot());
}
