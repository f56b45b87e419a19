import { expect, type Page, test } from "@playwright/test";
import { neverFullScreen, openFinished, resize } from "./riverpage.ts";
import { LONG_SEEDS, linkOfSeed, OPENED, openFailed } from "./states.ts";
import { core } from "./tiers.ts";

/** How much further than the window the page can be scrolled, and how far a wheel over the picture scrolls it. */
async function scrolls(page: Page): Promise<[number, number]> {
  await page.mouse.move(60, 200);
  await page.mouse.wheel(0, 3000);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.evaluate(() => [document.documentElement.scrollHeight - innerHeight, scrollY]);
}

/** Each state is reached in the first of these windows, where that is hardest, and then seen in all. */
const DESKS = [
  [1024, 768],
  [1440, 900],
  [1920, 1080],
] as const;
const WINDOWS = [
  [320, 568],
  [370, 780],
  [768, 1024],
  [1024, 768],
  [1440, 900],
] as const;

/** Does the same in windows of several sizes, and goes back to the first. */
async function inEach(
  page: Page,
  windows: readonly (readonly [number, number])[],
  look: (size: string) => Promise<void>,
): Promise<void> {
  const [first = [0, 0], ...others] = windows;
  for (const [width, height] of [first, ...others]) {
    await resize(page, width, height);
    await look(`${width} by ${height}`);
  }
  await resize(page, ...first);
}

test("on a desk the page never scrolls, in no state @core", async ({ page }) => {
  await neverFullScreen(page);
  await resize(page, ...DESKS[0]);
  await openFinished(page, linkOfSeed(LONG_SEEDS.letters));
  await expect(page.locator("#notices")).toBeVisible();
  for (const [state, open] of Object.entries(OPENED)) {
    await open(page);
    await inEach(page, DESKS, async (size) => expect(await scrolls(page), `${state}, ${size}`).toEqual([0, 0]));
  }
});

test("on a desk the page does not scroll when the engine has failed", async ({ page }) => {
  await openFailed(page);
  await inEach(page, DESKS, async (size) => expect(await scrolls(page), size).toEqual([0, 0]));
});

/** What is seen and stands out of the window sideways, or can be scrolled sideways; of dialogs, upward and downward too. */
function outside(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const named = (element: Element): string => element.outerHTML.slice(0, 120);
    const isSeen = (element: Element): boolean =>
      element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
      getComputedStyle(element).clipPath === "none" &&
      element.getClientRects().length > 0;
    // The rows of styles and of kinds of country are there to be scrolled.
    const rows = ":is(#styles, #countries .preset-buttons)";
    const seen = [...document.querySelectorAll(`body *:not(${rows}, ${rows} *)`)].filter(isSeen);
    const sideways = seen.filter((element) => {
      const { left, right } = element.getBoundingClientRect();
      return left < -0.5 || right > innerWidth + 0.5;
    });
    const cut = seen.filter((element) => {
      if (!element.matches("dialog, #notices")) return false;
      const { top, bottom } = element.getBoundingClientRect();
      return top < -0.5 || bottom > innerHeight + 0.5;
    });
    const scrolled = [document.documentElement, ...seen].filter((element) => {
      const isScroller =
        element === document.documentElement || /auto|scroll/.test(getComputedStyle(element).overflowX);
      return isScroller && element.scrollWidth > element.clientWidth;
    });
    return [...sideways, ...cut, ...scrolled].map(named);
  });
}

for (const [kind, seed] of Object.entries(LONG_SEEDS)) {
  test(`nothing stands out of the window, and nothing lies over the controls: ${kind}${core(kind === "letters")}`, async ({
    page,
  }) => {
    await neverFullScreen(page);
    await resize(page, ...WINDOWS[0]);
    await openFinished(page, linkOfSeed(seed));
    await inEach(page, WINDOWS, async () => {
      // Told that something else covers it, Playwright would not click.
      await page.getByRole("button", { name: "A new seed by chance" }).click({ trial: true });
    });
    for (const [state, open] of Object.entries(OPENED)) {
      await open(page);
      await inEach(page, WINDOWS, async (size) => expect(await outside(page), `${state}, ${size}`).toEqual([]));
    }
  });
}
