import type { Page } from "@playwright/test";
import { expect, type Host, test } from "./hosts.ts";
import {
  type Count,
  canonical,
  expectPicture,
  frames,
  type Heard,
  heard,
  listen,
  PROBED_WORKER,
  post,
  probe,
} from "./post.ts";

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/widget/worker.js", { headers: { "content-type": "text/javascript" }, body: PROBED_WORKER });
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

const BELOW = '<p style="height: 5000px">A long text.</p>';
/** So many rounds that no test sees the end of them. */
const LONG = '<river-seed seed="rimu" meander-rounds="400"></river-seed>';

/** Whether the engine makes steps while frames pass. */
async function isGrowing(page: Page): Promise<boolean> {
  const before: Count = await probe(page);
  await frames(page);
  return (await probe(page)).steps > before.steps;
}

test("nothing is fetched for a river far below, until the reader comes near @core", async ({ page, blog }) => {
  const events = await open(page, blog, `${BELOW}${LONG}`);
  await page.waitForFunction(() => customElements.get("river-seed"));
  await frames(page);
  expect(blog.asked).not.toContain("/widget/worker.js");
  await page.locator("river-seed").scrollIntoViewIfNeeded();
  await heard(events, "ready");
});

test("an eager river is there at once, and grows when it is seen", async ({ page, blog }) => {
  const events = await open(page, blog, `${BELOW}${LONG.replace("<river-seed", '<river-seed loading="eager"')}`);
  await heard(events, "ready");
  expect(await isGrowing(page)).toBe(false);
  await page.locator("river-seed").scrollIntoViewIfNeeded();
  await expect.poll(() => isGrowing(page)).toBe(true);
});

/** Waits until no widget is near the window, as the element itself counts it. */
async function scrollPast(page: Page): Promise<void> {
  await page.evaluate(async () => {
    scrollTo(0, document.body.scrollHeight);
    const river = document.querySelector("river-seed") ?? document.body;
    await new Promise<void>((done) => {
      const observer = new IntersectionObserver(
        ([entry]) => {
          if (entry?.isIntersecting === false) done();
        },
        { rootMargin: "150px" },
      );
      observer.observe(river);
    });
  });
  await frames(page, 5);
}

test("one that is read past is finished without a picture on the way, and is whole when scrolled back to @core", async ({
  page,
  blog,
}) => {
  const link = "seed=rimu&meander-rounds=200&style=ink&labels=none";
  const events = await open(page, blog, `<river-seed recipe="${link}"></river-seed>${BELOW}`);
  await heard(events, "progress");
  await scrollPast(page);
  const before = await probe(page);
  expect((await events()).map(({ type }) => type)).not.toContain("complete");
  await heard(events, "complete");
  const after = await probe(page);
  expect(after.steps).toBeGreaterThan(before.steps);
  expect(after.pictures - before.pictures).toBe(1);
  await expect.poll(async () => (await probe(page)).frames).toBe(0);
  await page.evaluate(() => scrollTo(0, 0));
  await expectPicture(page, canonical(link));
});

test("who comes back before it is finished sees it go on growing", async ({ page, blog }) => {
  const events = await open(page, blog, `${LONG}${BELOW}`);
  await heard(events, "progress");
  await scrollPast(page);
  await expect.poll(() => isGrowing(page)).toBe(true);
  await page.evaluate(() => scrollTo(0, 0));
  const { length } = await events();
  await expect.poll(async () => (await events()).slice(length).map(({ type }) => type)).toContain("progress");
  await heard(events, "complete");
});

test("twenty that are read past one after the other are all finished", async ({ page, blog }) => {
  const rivers = Array.from(
    { length: 20 },
    (_, i) => `<river-seed id="r${i}" recipe="seed=${i}&attractors=2000&style=ink&labels=none"></river-seed>`,
  );
  const events = await open(page, blog, `${rivers.join('<p style="height: 300px">Text.</p>')}${BELOW}`);
  for (let i = 0; i < 20; i++) {
    await page.locator(`#r${i}`).scrollIntoViewIfNeeded();
    await heard(events, "ready", i + 1);
  }
  await scrollPast(page);
  await heard(events, "complete", 20);
  expect((await probe(page)).frames).toBe(0);
});

test("in a hidden tab it stands still", async ({ page, blog }) => {
  const events = await open(page, blog, LONG);
  await heard(events, "progress");
  const hide = (isHidden: boolean): Promise<void> =>
    page.evaluate((isHidden) => {
      Object.defineProperty(document, "hidden", { value: isHidden, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
    }, isHidden);
  await hide(true);
  await expect.poll(() => isGrowing(page)).toBe(false);
  await hide(false);
  await expect.poll(() => isGrowing(page)).toBe(true);
});

test("a move in the document is no end and no beginning", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(
    page,
    blog,
    '<river-seed seed="rimu" attractors="300"></river-seed><div id="elsewhere"></div>',
  );
  await heard(events, "complete");
  await page.evaluate(() => {
    const river = document.querySelector("river-seed");
    if (river) document.querySelector("#elsewhere")?.append(river);
  });
  await frames(page);
  await expectPicture(page, canonical("seed=rimu&attractors=300"), "#elsewhere river-seed");
  expect(await probe(page)).toMatchObject({ rivers: 1 });
  // It still listens.
  await page.locator("river-seed").evaluate((river) => river.setAttribute("seed", "miro"));
  await expectPicture(page, canonical("seed=miro&attractors=300"));
  expect((await events()).filter(({ type }) => type === "ready")).toHaveLength(1);
});

test("ten rounds of coming and going leave nothing behind @core", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(page, blog, "");
  const bytes: number[] = [];
  for (let round = 1; round <= 10; round++) {
    await page.evaluate((round) => {
      const river = document.createElement("river-seed");
      Object.assign(river, { seed: `seed${round % 2}`, attractors: 1000, loading: "eager" });
      document.querySelector("main")?.append(river);
    }, round);
    await heard(events, "complete", round);
    await page.evaluate(() => document.querySelector("river-seed")?.remove());
    await expect.poll(async () => (await probe(page)).rivers).toBe(0);
    expect((await probe(page)).frames).toBe(0);
    bytes.push((await probe(page)).bytes);
  }
  expect(bytes.slice(2)).toEqual(Array(8).fill(bytes[1]));
});

test("one that is taken away while it loads leaves nothing behind", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed id="kept" attractors="300"></river-seed>');
  await page.evaluate(async () => {
    const rivers = Array.from({ length: 5 }, () =>
      Object.assign(document.createElement("river-seed"), { loading: "eager", attractors: 300 }),
    );
    document.querySelector("main")?.append(...rivers);
    for (const river of rivers) {
      river.remove();
      await new Promise(requestAnimationFrame);
    }
  });
  await heard(events, "ready");
  await expect.poll(async () => (await probe(page)).rivers).toBe(1);
});

test("the last one gone, the worker goes too; the next brings a new one", async ({ page, blog }) => {
  await page.clock.install();
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(page, blog, '<river-seed attractors="300" loading="eager"></river-seed>');
  await page.clock.runFor(1000);
  await heard(events, "complete");
  const river = await page.locator("river-seed").evaluateHandle((river) => {
    river.remove();
    return river;
  });
  await expect.poll(() => page.workers().length).toBe(1);
  await page.clock.runFor(6000);
  await expect.poll(() => page.workers().length).toBe(0);
  await river.evaluate((river) => document.querySelector("main")?.append(river));
  await page.clock.runFor(1000);
  await heard(events, "complete", 2);
  expect(page.workers()).toHaveLength(1);
});

test("another size is the same river", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(page, blog, '<river-seed seed="rimu" attractors="300"></river-seed>');
  await heard(events, "complete");
  const widthOf = (): Promise<number> => page.locator("canvas").evaluate((canvas: HTMLCanvasElement) => canvas.width);
  const before = await widthOf();
  await page.setViewportSize({ width: 500, height: 700 });
  await expect.poll(widthOf).not.toBe(before);
  await expectPicture(page, canonical("seed=rimu&attractors=300"));
});
