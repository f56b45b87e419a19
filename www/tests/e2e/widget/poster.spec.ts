/** The content in a river's place, and when it gives way. */

import type { Page } from "@playwright/test";
import type { RiverSeed } from "../../../src/apps/widget/element.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, frames, type Heard, heard, listen, post } from "./post.ts";

const PICTURE = `<img alt="A map" width="800" height="500" src="data:image/svg+xml,${encodeURIComponent(
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 5"><path fill="green" d="M0 0h8v5H0z"/></svg>',
)}">`;
const RECIPE = "seed=rimu&style=ink&labels=none&attractors=2000";
const NAMED = "seed=rimu&style=ink&labels=some&attractors=1500";

/** The element's phase and progress at one of its events. */
interface Seen {
  type: string;
  phase: string;
  progress: number;
}

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  await page.addInitScript(() => {
    const seen: Seen[] = [];
    Object.assign(globalThis, { seen_: seen });
    for (const type of ["ready", "progress", "complete"])
      document.addEventListener(
        type,
        ({ target }) => {
          const { phase, progress } = target as RiverSeed;
          seen.push({ type, phase, progress });
        },
        true,
      );
  });
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

async function firstPicture(page: Page): Promise<Seen | undefined> {
  const seen = await page.evaluate(() => (globalThis as unknown as { seen_: Seen[] }).seen_);
  return seen.find(({ type }) => type === "ready");
}

test("a picture is held until the map is finished, and the growth is seen on demand @core", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed recipe="${RECIPE}">${PICTURE}</river-seed>`);
  await heard(events, "complete");
  expect(await firstPicture(page)).toEqual({ type: "ready", phase: "finished", progress: 1 });
  await expectPicture(page, canonical(RECIPE));
  await expect(page.getByAltText("A map")).toBeHidden();
  await page.locator("river-seed").hover();
  await page.getByRole("button", { name: "Grow the rivers again" }).click();
  await expect(page.getByRole("button", { name: "Pause the rivers" })).toBeVisible();
  await heard(events, "complete", 2);
});

test("words give way to the first rivers, not to bare land", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed recipe="${RECIPE}"><p>The rivers of rimu.</p></river-seed>`);
  await heard(events, "ready");
  expect((await firstPicture(page))?.progress).toBeGreaterThan(0);
  expect((await firstPicture(page))?.phase).not.toBe("finished");
});

test("where there is nothing, the river is seen from the beginning", async ({ page, blog }) => {
  const caption = '<figcaption slot="caption">Rimu</figcaption>';
  const events = await open(page, blog, `<river-seed recipe="${RECIPE}">${caption}</river-seed>`);
  await heard(events, "ready");
  expect((await firstPicture(page))?.progress).toBe(0);
});

test("who plays a river before it is there sees it grow in place of the picture", async ({ page, blog }) => {
  const body = `<p style="height: 5000px"></p><river-seed recipe="${RECIPE}">${PICTURE}</river-seed>`;
  const events = await open(page, blog, body);
  await page.waitForFunction(() => customElements.get("river-seed"));
  await page.locator("river-seed").evaluate((river: RiverSeed) => river.play());
  await page.locator("river-seed").scrollIntoViewIfNeeded();
  await heard(events, "ready");
  expect((await firstPicture(page))?.phase).not.toBe("finished");
});

test("a picture is held until the map has its names as well", async ({ page, blog }) => {
  let answer = (): void => {};
  const asked = new Promise<void>((isAsked) => {
    void page.context().route("**/riverseed_label_bg.wasm", async (route) => {
      isAsked();
      await new Promise<void>((done) => {
        answer = done;
      });
      await route.continue();
    });
  });
  blog.headers = { "content-security-policy": "worker-src 'none'" };
  const events = await open(page, blog, `<river-seed recipe="${NAMED}" still>${PICTURE}</river-seed>`);
  await asked;
  await frames(page);
  await expect(page.getByAltText("A map")).toBeVisible();
  expect((await events()).map(({ type }) => type)).not.toContain("ready");
  answer();
  await heard(events, "complete");
  await expect(page.getByAltText("A map")).toBeHidden();
});

test("nothing moves when the map takes the place of its picture", async ({ page, blog }) => {
  await page.addInitScript(() => {
    Object.assign(globalThis, { moved_: 0 });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries())
        (globalThis as unknown as { moved_: number }).moved_ += (entry as unknown as { value: number }).value;
    }).observe({ type: "layout-shift", buffered: true });
  });
  const style = "<style>river-seed > img { display: block; width: 100%; height: auto }</style>";
  const reserve = "<style>river-seed:not(:defined) { display: block }</style>";
  const events = await open(
    page,
    blog,
    `${style}${reserve}<river-seed recipe="${RECIPE}">${PICTURE}<figcaption slot="caption">Rimu, from above</figcaption></river-seed>`,
  );
  await heard(events, "complete");
  await frames(page, 5);
  expect(await page.evaluate(() => (globalThis as unknown as { moved_: number }).moved_)).toBe(0);
});
