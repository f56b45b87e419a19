/** What is laid over a map while it grows, and at the moments of its making. */

import { expect, type Page, test } from "@playwright/test";
import { dotsOf, linesOf, ringsOf } from "../../src/browser/path-text.ts";
import { engine } from "../core.ts";
import { violations } from "./axe.ts";
import { complaints, finished, openFinished, openFold, ownClock, runUntil, stopClock } from "./riverpage.ts";
import { core } from "./tiers.ts";

const COLONIZED =
  "seed=kauri&land=island&growth=colonize&valleys=0&attractors=900&meander-rounds=4&style=ink&labels=none";
const DRAINED = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=4&style=ink&labels=none";

function card(page: Page) {
  return page.locator(".inside-card");
}

function track(page: Page) {
  return page.getByRole("slider", { name: "The making of the map" });
}

/** What is laid over the map of one kind. */
function laid(page: Page, kind: number): Promise<string | null> {
  const path = page.locator(`.inside [data-kind="${kind}"] path`);
  return path.count().then((count) => (count === 0 ? "" : path.getAttribute("d")));
}

/** How many lines are laid over the map, of the first kind. */
async function linesLaid(page: Page): Promise<number> {
  return ((await laid(page, 1)) ?? "").split("M").length - 1;
}

/** A third of the track on, by keys. */
async function goToGrowth(page: Page): Promise<void> {
  await expect(track(page)).toHaveAttribute("aria-disabled", "false");
  await track(page).focus();
  for (const key of ["Home", "PageUp", "PageUp", "PageUp"]) await page.keyboard.press(key);
  await expect(track(page)).toHaveAttribute("aria-valuetext", /^growth/);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
}

/** The river of a link where its attractors that are left are those; it grows until it is there. */
function grownTo(link: string, left: string): InstanceType<typeof engine.River> | undefined {
  const river = new engine.River(link);
  do {
    if (dotsOf(river.left()) === left) return river;
  } while (river.advance(1) && river.phase === "growing");
  return;
}

/** Space colonization leaves some attractors between its rivers. */
function leftAtTheEnd(link: string): string {
  const river = new engine.River(link);
  while (river.advance(1000));
  return dotsOf(river.left());
}

for (const [link, alive] of [
  [COLONIZED, /Alive: ([\d,]+)\./],
  [DRAINED, /No way to the sea yet: ([\d,]+)\./],
] as const) {
  test(`at a moment of growth what is left, and the tips, are those of then: ${link}${core(link === COLONIZED)}`, async ({
    page,
  }) => {
    const said = complaints(page);
    await openFinished(page, link);
    await page.keyboard.press("a");
    await expect.poll(() => laid(page, 2)).toBe(leftAtTheEnd(link));
    await goToGrowth(page);
    await expect.poll(async () => (await laid(page, 2))?.length).toBeGreaterThan(2 * leftAtTheEnd(link).length);
    await expect(card(page)).toHaveText(alive);
    await expect
      .poll(async () => {
        const count = Number(alive.exec((await card(page).textContent()) ?? "")?.[1]?.replaceAll(",", ""));
        return count === ((await laid(page, 2)) ?? "").split("M").length - 1;
      })
      .toBe(true);
    const river = grownTo(link, (await laid(page, 2)) ?? "");
    expect(await laid(page, 1)).toBe(river && dotsOf(river.scattered()));
    await page.keyboard.press("t");
    await expect.poll(() => laid(page, 1)).toBe(river && dotsOf(river.tips()));
    // A tick on there are others.
    await page.keyboard.press(".");
    await expect.poll(() => laid(page, 1)).not.toBe(river && dotsOf(river.tips()));
    await page.keyboard.press("o");
    await expect(card(page)).toContainText("This is known once the map is finished");
    await track(page).focus();
    await page.keyboard.press("End");
    await finished(page);
    await expect(card(page)).toContainText("Order 1");
    expect(said).toEqual([]);
  });
}

for (const [link, alive] of [
  [COLONIZED, /Alive: ([\d,]+)\.Used up: ([\d,]+)\./],
  [DRAINED, /No way to the sea yet: ([\d,]+)\.With a way: ([\d,]+)\./],
] as const) {
  test(`while a map grows, what is laid over it follows: ${link}`, async ({ page }) => {
    await ownClock(page);
    await page.goto(`./?${link}`);
    await finished(page);
    await page.keyboard.press("a");
    await expect(card(page)).toBeVisible();
    await stopClock(page);
    await page.getByRole("button", { name: "Replay" }).click();
    const counts = async () => {
      const [, left, rest] = alive.exec((await card(page).textContent()) ?? "") ?? [];
      return [left, rest].map((number) => Number(number?.replaceAll(",", "")));
    };
    await expect.poll(async () => (await counts())[1]).toBe(0);
    const [all = 0] = await counts();
    expect(await laid(page, 2)).toBe(dotsOf(new engine.River(link).left()));
    let left = all;
    for (const wanted of [0.8, 0.5]) {
      while (left > wanted * all) {
        await page.clock.runFor(50);
        [left = Number.NaN] = await counts();
      }
      await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
      const [now = 0, gone = 0] = await counts();
      expect(now + gone).toBe(all);
      await expect.poll(async () => ((await laid(page, 2)) ?? "").split("M").length - 1).toBe((await counts())[0]);
    }
    await page.keyboard.press("t");
    await expect
      .poll(async () => {
        // A letter may be one of a sentence, so it waits for the next.
        await page.clock.runFor(50);
        return linesLaid(page);
      })
      .toBeGreaterThan(2);
    const tips = await laid(page, 1);
    await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
    await expect
      .poll(async () => {
        // Answers need the page's clock, too.
        await page.clock.runFor(50);
        return laid(page, 1);
      })
      .not.toBe(tips);
    // What only a finished map has comes with its end.
    await page.keyboard.press("o");
    await page.clock.runFor(600);
    await expect(card(page)).toContainText("This is known once the map is finished");
    await runUntil(page, "finished");
    await expect(card(page)).toContainText("Order 1");
  });
}

test("the circles of reach and kill go with the pointer, and are as large as the recipe says", async ({ page }) => {
  await openFinished(page, COLONIZED);
  await page.keyboard.press("k");
  const river = new engine.River(COLONIZED);
  const { width, reach, kill } = river.lengths();
  expect(reach / kill).toBeCloseTo(2.3 / 1.1);
  const circle = page.locator(".inside circle.reach");
  expect(Number(await circle.getAttribute("r"))).toBe(reach);
  expect(Number(await page.locator(".inside circle.kill").getAttribute("r"))).toBe(kill);
  const box = await page.locator("#map-place").boundingBox();
  if (!box) throw new Error("there is no map");
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2);
  await expect.poll(async () => Number(await circle.getAttribute("cx"))).toBeCloseTo(width / 4, 0);
  const seen = await circle.boundingBox();
  // As wide on the screen, but for its own line.
  expect(Math.abs((seen?.width ?? 0) / 2 - reach * (box.width / width))).toBeLessThan(2);
  await page.locator("#frame").focus();
  await page.keyboard.press("+");
  // By keys, the middle of what is seen.
  await expect.poll(async () => Math.abs(Number(await circle.getAttribute("cx")) - width / 4)).toBeGreaterThan(50);
});

test("what a way of growing does not have cannot be asked for", async ({ page }) => {
  await openFinished(page, DRAINED);
  await openFold(page, "For the curious");
  await expect(page.getByRole("button", { name: "Reach and kill" })).toBeDisabled();
  await page.keyboard.press("k");
  await expect(card(page)).toBeHidden();
});

test("masks are water and ridges; curvature is there when the map is finished", async ({ page }) => {
  await openFinished(page, DRAINED.replace("island", "valley"));
  const river = new engine.River(DRAINED.replace("island", "valley"));
  while (river.advance(1000));
  await page.keyboard.press("m");
  await expect.poll(async () => (await laid(page, 1))?.endsWith(ringsOf(river.coasts()))).toBe(true);
  expect(await laid(page, 2)).toBe(linesOf(river.ridges()));
  expect(linesOf(river.ridges())).toMatch(/^M/);
  await page.keyboard.press("c");
  await expect(page.locator('.inside[data-look="curvature"]')).toHaveCount(1);
  await expect.poll(() => linesLaid(page)).toBeGreaterThan(40);
  await page.keyboard.press("c");
  await expect(card(page)).toBeHidden();
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`axe finds nothing with attractors and circles over a map that stands still: ${colorScheme}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 320, height: 700 });
    await openFinished(page, COLONIZED);
    await goToGrowth(page);
    await page.keyboard.press("k");
    await expect(card(page)).toContainText("Reach:");
    expect(await violations(page)).toEqual([]);
    const box = await card(page).boundingBox();
    expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(320);
  });
}

test("the mask of water has no edge where the map ends: its sea goes on", async ({ page }) => {
  await openFinished(page, "land=island&attractors=300");
  await page.keyboard.press("m");
  const mask = await page.locator('.inside [data-kind="1"] path').boundingBox();
  const window = page.viewportSize();
  if (!mask || !window) throw new Error("no mask");
  expect(mask.x).toBeLessThan(0);
  expect(mask.y).toBeLessThan(0);
  expect(mask.x + mask.width).toBeGreaterThan(window.width);
  expect(mask.y + mask.height).toBeGreaterThan(window.height);
  await expect(page.locator(".inside")).toHaveCSS("overflow", "visible");
});
