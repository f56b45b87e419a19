import { expect, type Page, test } from "@playwright/test";
import { neverFullScreen, openFinished, openPanel, openUnfolded, resize, showAll } from "./riverpage.ts";
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
    await showAll(page);
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

test("the bar is in one row on a desk and a tablet, with the panel and without, and not under it", async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await openFinished(page, "attractors=300&style=ink&labels=none");
  const height = async (): Promise<number> => (await page.locator(".bar").boundingBox())?.height ?? 0;
  for (const [width, isOpen] of [
    [620, false],
    [720, false],
    [800, false],
    [1000, false],
    [1024, false],
    [1100, false],
    [1280, false],
    [1300, false],
    [1440, false],
    [620, true],
    [1000, true],
    [1024, true],
    [1200, true],
    [1300, true],
    [1440, true],
    [1680, true],
  ] as const) {
    await page.setViewportSize({ width, height: 768 });
    if (isOpen) await openPanel(page);
    expect(await height(), `${width}, ${isOpen}`).toBeLessThan(60);
    for (const name of ["Draw", "Replay"]) await expect(page.getByRole("button", { name, exact: true })).toBeVisible();
    // Told that something else covers it, Playwright would not click.
    await page.getByRole("button", { name: "Share", exact: true }).click({ trial: true });
  }
});

test("nothing slides over the panel's head", async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 });
  await openUnfolded(page, "attractors=300&style=ink&labels=none");
  const covered = await page.evaluate(async () => {
    const panel = document.querySelector("#panel");
    const close = document.querySelector("#panel-close");
    if (!panel || !close) throw new Error("no panel");
    const { x, y, width, height } = close.getBoundingClientRect();
    const over = new Set<string>();
    for (let at = 0; at < panel.scrollHeight; at += 7) {
      panel.scrollTop = at;
      const top = document.elementFromPoint(x + width / 2, y + height / 2);
      if (top?.closest("#panel-close") === null) over.add(top.className);
    }
    return [...over];
  });
  expect(covered).toEqual([]);
});

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [768, 1024],
  [390, 844],
  [320, 568],
] as const) {
  test(`the map's title lies beside the map, not over its land or its scale: ${width} by ${height}`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page, "seed=Ardenmoor&attractors=600&style=atlas&labels=some");
    const caption = await page.locator(".caption").boundingBox();
    const map = await page.locator("#map-place").boundingBox();
    if (!caption || !map) throw new Error("no map");
    const isBeside = caption.y + caption.height <= map.y + 0.5 || caption.y >= map.y + map.height - 0.5;
    expect(isBeside, JSON.stringify({ caption, map })).toBe(true);
    const others = await page.locator(".masthead h1, .gallery-link, .zoom, .styles").all();
    for (const other of others) {
      const box = await other.boundingBox();
      if (!box) continue;
      const isClear =
        caption.x + caption.width <= box.x ||
        box.x + box.width <= caption.x ||
        caption.y + caption.height <= box.y ||
        box.y + box.height <= caption.y + 1;
      expect(isClear, JSON.stringify({ caption, box })).toBe(true);
    }
  });
}

for (const height of [900, 560])
  test(`the strip of styles ends below the last of them, and above the bar: ${height} high`, async ({ page }) => {
    await page.setViewportSize({ width: 1440, height });
    await openFinished(page, "attractors=300");
    const strip = page.locator("#styles");
    await expect(strip.locator("canvas").filter({ visible: true })).toHaveCount(6);
    const { rest, above, hidden } = await strip.evaluate((element) => {
      const bottom = element.getBoundingClientRect().bottom;
      const last = element.lastElementChild?.getBoundingClientRect().bottom ?? 0;
      const bar = document.querySelector(".bar")?.getBoundingClientRect().top ?? 0;
      return { rest: bottom - last, above: bar - bottom, hidden: element.scrollHeight - element.clientHeight };
    });
    expect(above).toBeGreaterThan(0);
    // What has no room is scrolled to.
    if (hidden === 0) expect(rest).toBeLessThan(12);
    expect(hidden > 0).toBe(height === 560);
  });
