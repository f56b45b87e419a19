import { expect, type Page, test } from "@playwright/test";
import { complaints, expectPictureOfAddress, finished, openFinished, unfold } from "./riverpage.ts";
import { core } from "./tiers.ts";

const LINK = "seed=kauri&attractors=300&style=atlas&labels=some";

/** A canvas of few colours is a blank. */
async function expectNoBlank(page: Page): Promise<void> {
  const colours = () =>
    page.locator("#canvas").evaluate((canvas) => {
      const { width, height } = canvas as HTMLCanvasElement;
      const copy = new OffscreenCanvas(width, height).getContext("2d");
      copy?.drawImage(canvas as HTMLCanvasElement, 0, 0);
      return new Set(new Uint32Array(copy?.getImageData(0, 0, width, height).data.buffer ?? [])).size;
    });
  await expect.poll(colours).toBeGreaterThan(30);
}

/** All that can be pressed; in dialogs it is not seen. */
const PRESSED = ":is(button, summary, .seed input[type=checkbox]):not(:disabled)";

/** Whether a button has heard a double click, or is gone by one. */
function wasHit(button: Element): boolean {
  return !button.isConnected || (button as HTMLElement).dataset["heard"] !== undefined;
}

test("whatever is clicked twice in a moment, there is a map, that of the address, and nothing fails", async ({
  page,
}) => {
  test.slow();
  const said = complaints(page);
  await openFinished(page, LINK);
  await unfold(page);
  await page.evaluate((pressed) => {
    const hear = ({ target }: Event): void => {
      const button = target instanceof Element ? target.closest<HTMLElement>(pressed) : null;
      if (button) button.dataset["heard"] = "";
    };
    document.addEventListener("click", hear, true);
  }, PRESSED);
  const buttons = await page.$$(PRESSED);
  let clicked = 0;
  for (const button of buttons) {
    // The list of styles is made anew by some, and then there are others in their place.
    if (!(await button.isVisible()) || !(await button.isEnabled())) continue;
    await button.scrollIntoViewIfNeeded();
    await button.dblclick({ force: true });
    clicked += Number(await button.evaluate(wasHit));
    await expect(page.locator(".failure:visible")).toHaveCount(0);
    if ((await page.locator("dialog[open]").count()) > 0) await page.keyboard.press("Escape");
    await expect(page.locator("dialog[open]")).toHaveCount(0);
    if (await page.locator("#panel").isHidden()) await unfold(page);
  }
  expect(clicked).toBeGreaterThan(40);
  await expectPictureOfAddress(page);
  await expectNoBlank(page);
  expect(said).toEqual([]);
});

for (const [dialog, opener] of [
  ["save", "#download"],
  ["share", "#share"],
  ["help", "#help"],
] as const)
  test(`whatever is clicked twice in a moment in the dialog of ${dialog}, the map stays and nothing fails`, async ({
    page,
  }) => {
    test.slow();
    const said = complaints(page);
    await openFinished(page, LINK);
    const open = async () => {
      if ((await page.locator("dialog[open]").count()) === 0) await page.locator(opener).click();
    };
    await open();
    let clicked = 0;
    for (const button of await page.$$("dialog[open] :is(button, summary, input:is([type=radio], [type=checkbox]))")) {
      await open();
      if (!(await button.isVisible()) || !(await button.isEnabled())) continue;
      await button.dblclick();
      clicked++;
    }
    expect(clicked).toBeGreaterThan(dialog === "help" ? 0 : 4);
    await page.keyboard.press("Escape");
    await expectPictureOfAddress(page);
    expect(said).toEqual([]);
  });

/** In the page: until some frames have been seen. */
async function frames(): Promise<void> {
  for (let i = 0; i < 8; i++) await new Promise((done) => requestAnimationFrame(done));
}

/** From a watch to a wall, in pixels. */
const WINDOWS = [
  [5120, 700],
  [180, 180],
  [320, 2400],
  [3440, 240],
  [1, 1],
  [1280, 720],
] as const;

test("while rivers grow the window takes any size, and at last they are those of the address", async ({ page }) => {
  const said = complaints(page);
  await page.goto(`./?${LINK.replace("=300", "=20000")}`);
  for (const [width, height] of WINDOWS) {
    await page.setViewportSize({ width, height });
    await page.evaluate(frames);
  }
  await finished(page);
  await expectPictureOfAddress(page);
  await expectNoBlank(page);
  expect(said).toEqual([]);
});

for (const [width, height] of WINDOWS.filter(([width]) => width > 1))
  test(`in a window of ${width} by ${height} there is a map, and the dice can be thrown${core(width === 320)}`, async ({
    page,
  }) => {
    const said = complaints(page);
    await page.setViewportSize({ width, height });
    await openFinished(page, LINK);
    await expectNoBlank(page);
    const before = page.url();
    await page.locator("#dice").click();
    await expect.poll(() => page.url()).not.toBe(before);
    await finished(page);
    await expectNoBlank(page);
    expect(said).toEqual([]);
  });
