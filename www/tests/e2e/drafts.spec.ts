import { expect, type Page, test } from "@playwright/test";
import {
  address,
  complaints,
  countCalls,
  expectAddress,
  expectPictureOfAddress,
  finished,
  ownClock,
  shown,
  stopClock,
  unfold,
} from "./riverpage.ts";

const LINK =
  "country=usual&seed=kauri&land=island&sea=0.55&growth=drainage&attractors=1500&meander-rounds=9&style=atlas&labels=some&width=16&mountains=2&plains=100&drowning=0.24&roughness=1";

/** Moves a slider by a step as a hand does that holds it. */
async function move(page: Page, slider: string, by: number): Promise<void> {
  await page.locator(slider).evaluate((element, by) => {
    const slider = element as HTMLInputElement;
    slider.valueAsNumber += by * Math.max(Number(slider.step), (Number(slider.max) - Number(slider.min)) / 40);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, by);
}

/** Opens the finished map with its panel; the page draws itself, by a clock that stands still. */
async function openHeld(page: Page): Promise<void> {
  await ownClock(page);
  await page.goto(`./?${LINK}`);
  await finished(page);
  await unfold(page);
  await expectPictureOfAddress(page);
  await stopClock(page);
  await page.clock.runFor(2000);
}

test("while a slider moves its rivers are drafts without labels, and nothing is made exactly before the hand rests @core", async ({
  page,
}) => {
  const drafts = await countCalls(page, "river_paintUnfinished");
  const steps = await countCalls(page, "river_advance");
  // Its last argument says that a picture is to be bare.
  const labels = await countCalls(page, "river_paint with 0");
  await openHeld(page);
  for (const slider of ["#field-simplify", "#macro-winding"]) {
    const labelled = (await labels()).onPage;
    const pictures = [(await shown(page)).sha256];
    for (let i = 0; i < 3; i++) {
      const drafted = (await drafts()).onPage;
      await move(page, slider, 1);
      await page.clock.runFor(50);
      expect((await drafts()).onPage).toBeGreaterThan(drafted);
      pictures.push((await shown(page)).sha256);
      // The hand may move on: nothing is done meanwhile.
      const made = (await steps()).onPage;
      await page.clock.runFor(50);
      expect((await steps()).onPage).toBe(made);
    }
    expect(new Set(pictures).size, slider).toBe(4);
    expect((await labels()).onPage).toBe(labelled);
    await expect(page.locator("#frame")).toHaveAttribute("data-state", "settling");
    await page.clock.runFor(5000);
    expect((await labels()).onPage).toBeGreaterThan(labelled);
    await expectPictureOfAddress(page);
  }
});

test("another width is seen on the courses that are there, without a step, until the hand rests", async ({ page }) => {
  const steps = await countCalls(page, "river_advance");
  await openHeld(page);
  const made = (await steps()).onPage;
  const before = (await shown(page)).sha256;
  await move(page, "#field-width", 3);
  await page.clock.runFor(50);
  const wider = (await shown(page)).sha256;
  expect(wider).not.toBe(before);
  // Back to where it was: the map is again what it was, labels and all.
  await move(page, "#field-width", -3);
  await page.clock.runFor(50);
  expect((await shown(page)).sha256).not.toBe(wider);
  expect((await steps()).onPage).toBe(made);
  await page.clock.runFor(5000);
  expect([(await shown(page)).sha256, (await steps()).onPage]).toEqual([before, made]);
  await move(page, "#field-width", 3);
  await page.clock.runFor(5000);
  expect((await steps()).onPage).toBeGreaterThan(made);
  await expectPictureOfAddress(page);
});

for (const [what, [first, by], [second, by2]] of [
  ["other mountains and plains are seen at once", ["#field-mountains", 3], ["#field-plains", 3]],
  ["other coasts are seen around the rivers that are there", ["#field-sea", 3], ["#field-roughness", -6]],
] as const)
  test(`${what}, without a step, and exactly when the hand rests`, async ({ page }) => {
    const steps = await countCalls(page, "river_advance");
    await openHeld(page);
    const [made, before] = [(await steps()).onPage, (await shown(page)).sha256];
    const pictures = [before];
    for (const [slider, far] of [
      [first, by],
      [second, by2],
    ] as const) {
      await move(page, slider, far);
      await page.clock.runFor(100);
      pictures.push((await shown(page)).sha256);
    }
    expect(new Set(pictures).size).toBe(3);
    expect((await steps()).onPage).toBe(made);
    // Back to where it was: the map is again what it was, relief, labels and all.
    await move(page, second, -by2);
    await page.clock.runFor(100);
    await move(page, first, -by);
    await page.clock.runFor(5000);
    expect([(await shown(page)).sha256, (await steps()).onPage]).toEqual([before, made]);
    await move(page, first, by);
    await page.clock.runFor(100);
    expect((await steps()).onPage).toBe(made);
    await page.clock.runFor(5000);
    expect((await steps()).onPage).toBeGreaterThan(made);
    await expectPictureOfAddress(page);
  });

test("each link of a moving slider is read once by the page and once by the core, however many parts its draft has", async ({
  page,
}) => {
  const reads = await countCalls(page, "readLink");
  const drafts = await countCalls(page, "river_draft");
  const parts = await countCalls(page, "river_paintDraft");
  const adopted = await countCalls(page, "river_adoptDraft");
  const changes = await countCalls(page, "river_change");
  await openHeld(page);
  const all = async () => [(await reads()).onPage, (await drafts()).onPage, (await changes()).onPage];
  const before = await all();
  const painted = (await parts()).onPage;
  for (let i = 0; i < 3; i++) {
    await move(page, "#field-mountains", 1);
    await page.clock.runFor(100);
  }
  expect((await parts()).onPage - painted).toBeGreaterThan(3);
  expect(await all()).toEqual(before.map((count, i) => count + (i < 2 ? 3 : 0)));
  // At rest the core goes over to what it has read; only the small pictures of the styles are changed by their links.
  await page.clock.runFor(5000);
  expect((await adopted()).onPage).toBe(1);
  await expectPictureOfAddress(page);
});

test("whatever slider moved, the map after it is that of the address, to the pixel", async ({ page }) => {
  const said = complaints(page);
  await page.goto(`./?${LINK}`);
  await finished(page);
  await unfold(page);
  const sliders = [
    "width",
    "simplify",
    "channel-area",
    "mountains",
    "plains",
    "shade",
    "label-size",
    "concavity",
    "sea",
  ];
  for (const key of sliders) {
    const before = address(page).get(key);
    for (let i = 0; i < 4; i++) await move(page, `#field-${key}`, 1);
    await expect.poll(() => address(page).get(key)).not.toBe(before);
    await expectPictureOfAddress(page);
  }
  expect(said).toEqual([]);
});

test("a hand that goes on before the map is finished is followed, and its end is the address's", async ({ page }) => {
  await page.goto(`./?${LINK}`);
  await finished(page);
  await unfold(page);
  for (const key of ["width", "simplify", "width", "concavity", "simplify", "width"]) {
    await move(page, `#field-${key}`, 1);
    await move(page, `#field-${key}`, 1);
  }
  for (const key of ["width", "simplify", "concavity"])
    await expectAddress(page, key, await page.locator(`#exact-${key}`).inputValue());
  await expectPictureOfAddress(page);
});
