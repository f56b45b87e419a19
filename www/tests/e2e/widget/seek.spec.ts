/** How far a river is, and how to go there. */

import type { Page } from "@playwright/test";
import type { RiverSeed } from "../../../src/apps/widget/element.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, type Heard, heard, listen, pixels, post } from "./post.ts";

const RECIPE = "seed=rimu&style=ink&labels=none&attractors=2000";
const RIVER = `<river-seed recipe="${RECIPE}"></river-seed>`;

async function open(page: Page, blog: Host, body = RIVER): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

function seek(page: Page, share: number): Promise<void> {
  return page.locator("river-seed").evaluate((river: RiverSeed, share) => river.seek(share), share);
}

function progress(page: Page): Promise<number> {
  return page.locator("river-seed").evaluate((river: RiverSeed) => river.progress);
}

test("progress goes from 0 to 1, in the property and in the event", async ({ page, blog }) => {
  const events = await open(page, blog);
  await heard(events, "complete");
  const shares = (await events()).flatMap(({ detail }) =>
    typeof detail["progress"] === "number" ? detail["progress"] : [],
  );
  expect(shares.length).toBeGreaterThan(1);
  expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  expect(shares.every((share) => share >= 0 && share <= 1)).toBe(true);
  expect(await progress(page)).toBe(1);
});

test("seeking goes there and pauses, forward and back; the same share is the same picture @core", async ({
  page,
  blog,
}) => {
  const events = await open(page, blog);
  await heard(events, "complete");
  const at = async (share: number): Promise<string> => {
    await seek(page, share);
    await expect.poll(() => progress(page)).toBeCloseTo(share, 1);
    await expect(page.getByRole("button", { name: "Let the rivers grow" })).toBeVisible();
    return (await pixels(page)).sha256;
  };
  const early = await at(0.2);
  const late = await at(0.4);
  expect(late).not.toBe(early);
  expect(await at(0.2)).toBe(early);
  await seek(page, 1);
  await heard(events, "complete", 2);
  await expectPicture(page, canonical(RECIPE));
});

test("a river that is sought before it begins begins there", async ({ page, blog }) => {
  const events = await open(page, blog, `<p style="height: 5000px"></p>${RIVER}`);
  await page.waitForFunction(() => customElements.get("river-seed"));
  await seek(page, 0.3);
  await page.locator("river-seed").scrollIntoViewIfNeeded();
  await heard(events, "ready");
  await expect.poll(() => progress(page)).toBeCloseTo(0.3, 1);
  await expect(page.getByRole("button", { name: "Let the rivers grow" })).toBeVisible();
  await page.getByRole("button", { name: "Let the rivers grow" }).click();
  await heard(events, "complete");
});

test("the promise of a river that is sought back is of its next end", async ({ page, blog }) => {
  const events = await open(page, blog);
  await heard(events, "complete");
  const end = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const before = river.finished;
    river.seek(0.2);
    const isNew = river.finished !== before;
    river.seek(1);
    const { link } = await river.finished;
    return [isNew, link, river.progress];
  });
  expect(end).toEqual([true, canonical(RECIPE), 1]);
});

test("a storm of shares, sense or none, ends at the last", async ({ page, blog }) => {
  const events = await open(page, blog);
  await heard(events, "ready");
  await page.locator("river-seed").evaluate((river: RiverSeed) => {
    for (const share of [0.9, Number.NaN, -3, "x", 1e9, 0.1, 0.6, 0.25]) river.seek(share as number);
  });
  await expect.poll(() => progress(page)).toBeCloseTo(0.25, 1);
  expect((await events()).filter(({ type }) => type === "error")).toEqual([]);
});
