/** The things around the map: its caption, and the link to its maker. */

import type { Page } from "@playwright/test";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, type Heard, heard, listen, post } from "./post.ts";

const RECIPE = "seed=rimu&attractors=300&style=ink&labels=none";
const CAPTION = '<figcaption slot="caption">The rivers of <em>rimu</em></figcaption>';

async function open(page: Page, blog: Host, attributes: string, content = ""): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(`<river-seed recipe="${RECIPE}" still ${attributes}>${content}</river-seed>`) });
  await page.goto(blog.origin);
  await heard(events, "complete");
  return events;
}

async function box(page: Page, selector: string): Promise<{ x: number; y: number; width: number; height: number }> {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`${selector} is nowhere`);
  return box;
}

test("a caption stands below the map, which keeps its shape @core", async ({ page, blog }) => {
  await open(page, blog, "", CAPTION);
  await expect(page.getByText("The rivers of rimu")).toBeVisible();
  await expectPicture(page, canonical(RECIPE));
  const [map, caption, all] = [await box(page, "canvas"), await box(page, "figcaption"), await box(page, "river-seed")];
  expect(map.width / map.height).toBeCloseTo(1.6, 1);
  expect(caption.y).toBeGreaterThanOrEqual(Math.floor(map.y + map.height));
  expect(all.height).toBeCloseTo(map.height + caption.height, 0);
});

test("in a box of another shape the caption has room, and the map what is left", async ({ page, blog }) => {
  await open(page, blog, 'style="height: 220px"', CAPTION);
  const [map, caption, all] = [await box(page, "canvas"), await box(page, "figcaption"), await box(page, "river-seed")];
  expect(all.height).toBe(220);
  expect(caption.y + caption.height).toBeLessThanOrEqual(all.y + 220);
  expect(map.height).toBeCloseTo(220 - caption.height, 0);
});

test("a caption comes and goes with the page", async ({ page, blog }) => {
  await open(page, blog, "");
  const { height } = await box(page, "river-seed");
  await page
    .locator("river-seed")
    .evaluate((river, caption) => river.insertAdjacentHTML("beforeend", caption), CAPTION);
  await expect.poll(async () => (await box(page, "river-seed")).height).toBeGreaterThan(height);
  await expectPicture(page, canonical(RECIPE));
  await page.locator("figcaption").evaluate((caption) => caption.remove());
  await expect.poll(async () => (await box(page, "river-seed")).height).toBe(height);
});

test("after a failure the caption stands below the fallback", async ({ page, blog }) => {
  const events = await listen(page);
  blog.answer("/widget/riverseed_label_bg.wasm", { status: 404 });
  blog.answer("/", { body: post(`<river-seed maker="https://maps.example/">${CAPTION}<p>No map.</p></river-seed>`) });
  await page.goto(blog.origin);
  await heard(events, "error");
  await expect(page.getByText("No map.")).toBeVisible();
  await expect(page.getByText("The rivers of rimu")).toBeVisible();
  await expect(page.getByRole("link")).toHaveCount(0);
  expect((await box(page, "river-seed")).height).toBeLessThan(150);
});

test("a link leads to the same map at its maker's, if the author names one @core", async ({ page, blog }) => {
  await open(page, blog, 'maker="https://maps.example/rivers/?old#part"');
  const link = page.getByRole("link", { name: "Made with Riverseed" });
  await expect(link).toHaveAttribute("href", `https://maps.example/rivers/?${canonical(RECIPE)}`);
  await page.locator("river-seed").evaluate((river) => river.setAttribute("seed", "totara"));
  const other = canonical(RECIPE.replace("rimu", "totara"));
  await expect(link).toHaveAttribute("href", `https://maps.example/rivers/?${other}`);
  await page.locator("river-seed").evaluate((river) => river.removeAttribute("maker"));
  await expect(link).toHaveCount(0);
});

for (const maker of [undefined, "", "http://", "javascript:alert(1)", "data:text/html,hello"]) {
  test(`there is no link by maker=${maker}`, async ({ page, blog }) => {
    await open(page, blog, maker === undefined ? "" : `maker="${maker}"`);
    await expect(page.getByRole("link")).toHaveCount(0);
  });
}

test("an address beside the page is one, and the words are the author's", async ({ page, blog }) => {
  await open(page, blog, 'maker="/rivers/"');
  await page.locator("river-seed").evaluate((river: HTMLElementTagNameMap["river-seed"]) => {
    river.i18n = { maker: "Fait avec Riverseed" };
  });
  const link = page.getByRole("link", { name: "Fait avec Riverseed" });
  await expect(link).toHaveAttribute("href", `${blog.origin}/rivers/?${canonical(RECIPE)}`);
});
