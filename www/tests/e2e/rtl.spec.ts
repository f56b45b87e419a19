/** The page from right to left, and in forced colours: all of it is there, mirrored, and can be read. */

import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { neverFullScreen, openFinished, openPanel, openSettings, resize } from "./riverpage.ts";
import { OPENED } from "./states.ts";
import { core } from "./tiers.ts";

const SEEDS = { Arabic: "نهر النيل", Hebrew: "נהר הירדן" };

async function openMirrored(page: Page, seed: string): Promise<void> {
  await page.addInitScript(() => {
    new MutationObserver((_, observer) => {
      if (!document.documentElement) return;
      document.documentElement.dir = "rtl";
      observer.disconnect();
    }).observe(document, { childList: true });
  });
  await openFinished(page, `seed=${encodeURIComponent(seed)}&attractors=600&labels=none&style=ink`);
}

/** What of buttons, fields and words, but for the rows that are there to be scrolled, lies beyond the window's edges, or sideways beyond those of what scrolls. */
function cutOff(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, p, h1, h2, h3, label, summary")]
      .filter(
        (one) =>
          one.checkVisibility() &&
          !one.closest(".unseen, .styles, #countries .preset-buttons, [data-style] svg") &&
          !one.matches(".unseen"),
      )
      .filter((one) => {
        const { left, right, width } = one.getBoundingClientRect();
        return width > 1 && (left < -1 || right > innerWidth + 1);
      })
      .map((one) => one.outerHTML.slice(0, 120)),
  );
}

for (const [language, seed] of Object.entries(SEEDS)) {
  test(`from right to left nothing is cut off: ${language}${core(language === "Arabic")}`, async ({ page }) => {
    // Each state is reached in the narrowest window, and seen in all.
    await neverFullScreen(page);
    await resize(page, 320, 800);
    await openMirrored(page, seed);
    for (const [state, open] of Object.entries(OPENED)) {
      await open(page);
      for (const width of [320, 390, 1440, 320]) {
        await resize(page, width, 800);
        const where = `${state}, ${width} wide`;
        expect(await cutOff(page), where).toEqual([]);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(overflow, where).toBeLessThanOrEqual(0);
      }
    }
  });
}

test("from right to left the panel and the styles are on the left, and the map beside them @core", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openMirrored(page, SEEDS.Arabic);
  await openPanel(page);
  const box = async (selector: string) => {
    const found = await page.locator(selector).boundingBox();
    if (!found) throw new Error(`no ${selector}`);
    return found;
  };
  const [panel, styles, map] = [await box("#panel"), await box("#styles"), await box("#map-place")];
  expect(panel.x).toBe(0);
  expect(styles.x).toBeGreaterThanOrEqual(panel.x + panel.width);
  expect(map.x).toBeGreaterThanOrEqual(styles.x + styles.width);
  expect(map.x + map.width).toBeLessThanOrEqual(1440);
});

test("from right to left a click beside a slider's thumb goes where the hand points", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openMirrored(page, SEEDS.Hebrew);
  await openSettings(page);
  const speed = page.locator("#speed");
  await speed.scrollIntoViewIfNeeded();
  const box = await speed.boundingBox();
  if (!box) throw new Error("no slider");
  await page.mouse.click(box.x + box.width - 4, box.y + box.height / 2);
  await expect(speed).toHaveValue((await speed.getAttribute("max")) ?? "");
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`in forced colours axe finds nothing in panel and dialogs, and what is pressed stands out: ${colorScheme}${core(colorScheme === "light")}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme, forcedColors: "active" });
    await openFinished(page, "attractors=300&style=ink");
    for (const [where, open] of Object.entries(OPENED)) {
      await open(page);
      // Colours on their way are none to be judged by.
      await expect.poll(() => violations(page), where).toEqual([]);
      expect(await unmarked(page), where).toEqual([]);
    }
  });
}

/** Pressed buttons that look in forced colours as they would at rest: same edge, same outline, same ground. */
function unmarked(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const look = (button: Element): string => {
      const { backgroundColor, borderColor, outlineStyle, outlineColor, color, borderWidth } = getComputedStyle(button);
      return [backgroundColor, borderColor, borderWidth, outlineStyle, outlineColor, color].join();
    };
    return [...document.querySelectorAll('[aria-pressed="true"]')]
      .filter((button) => button.checkVisibility())
      .filter((button) => {
        const pressed = look(button);
        button.setAttribute("aria-pressed", "false");
        const atRest = look(button);
        button.setAttribute("aria-pressed", "true");
        return pressed === atRest;
      })
      .map((button) => button.outerHTML.slice(0, 120));
  });
}
