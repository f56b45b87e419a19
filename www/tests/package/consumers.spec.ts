/** Programs that use the packed tarball, in a browser: what they give the element arrives, and what it tells they hear. */

import { expect, type Page, test } from "@playwright/test";
import { embeddedPictureOf, pictureOf } from "../core.ts";
import { complaints } from "../e2e/riverpage.ts";
import { pixels } from "./pixels.ts";

/** What every program asks for, besides a seed. */
const recipe = (seed: string): string => `seed=${seed}&attractors=300&width=20`;

test.use({ reducedMotion: "reduce" });

/** What is seen is what the core draws of a recipe, to the pixel. */
async function expectRiver(page: Page, link: string): Promise<void> {
  await expect
    .poll(async () => {
      const png = await page.locator("river-seed").screenshot();
      const { width, height, sha256 } = await page.evaluate(pixels, png.toString("base64"));
      return sha256 === embeddedPictureOf(link, width, height).sha256;
    })
    .toBe(true);
}

/** Rivers grow where they do not hold the page up: bundlers have taken the worker along. */
function expectWorker(page: Page): void {
  expect(page.workers()).toHaveLength(1);
}

for (const program of ["vite", "react", "vue", "svelte"]) {
  test(`${program}: values go in, events come out`, async ({ page }) => {
    const said = complaints(page);
    await page.goto(`./${program}/`);
    for (const seed of ["kauri", "rimu"]) {
      await page.getByLabel("Word").fill(seed);
      await page.getByLabel("Word").blur();
      const { sources } = pictureOf(recipe(seed), 100, 100).summary;
      await expect(page.locator("output")).toHaveText(`${sources} sources`);
      await expectRiver(page, recipe(seed));
    }
    expectWorker(page);
    expect(said).toEqual([]);
  });
}

test("a post in Markdown: the snippet is all that it takes", async ({ page }) => {
  const said = complaints(page);
  await page.goto("./blog/");
  await expectRiver(page, recipe("kauri"));
  expectWorker(page);
  await expect(page.locator("h1")).toHaveText("Rivers from a word");
  expect(said).toEqual([]);
});
