import type { Page } from "@playwright/test";
import { elementSnippet } from "../../../src/apps/page/share/snippets.ts";
import { engine } from "../../core.ts";
import { core } from "../tiers.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, frames, type Heard, heard, listen, post } from "./post.ts";

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

/** How far the page has moved by itself, as browsers count it. */
async function shifts(page: Page): Promise<() => Promise<number>> {
  await page.addInitScript(() => {
    const score = { sum: 0 };
    Object.assign(globalThis, { shifts_: score });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) score.sum += (entry as unknown as { value: number }).value;
    }).observe({ type: "layout-shift", buffered: true });
  });
  return () => page.evaluate(() => (globalThis as unknown as { shifts_: { sum: number } }).shifts_.sum);
}

const FALLBACK =
  '<a href="#river">The river</a><p style="height: 700px">A picture of the river, taller than its place.</p>';

for (const [attributes, aspect] of [
  ["", 1.6],
  ['aspect="2.5"', 2.5],
  ['recipe="aspect=0.8"', 0.8],
  ['aspect="77"', 4],
] as const) {
  test(`nothing moves when the river comes: ${attributes || "the default"}${core(attributes === "")}`, async ({
    page,
    blog,
  }) => {
    const moved = await shifts(page);
    // What docs/element.md recommends for the time before the script has come.
    const style = `<style>river-seed:not(:defined) { display: block; aspect-ratio: ${aspect}; min-height: 0; overflow: hidden }</style>`;
    const body = `${style}<river-seed attractors="300" still ${attributes}>${FALLBACK}</river-seed>`;
    const events = await open(page, blog, body);
    await heard(events, "complete");
    await frames(page, 5);
    const { width, height } = (await page.locator("river-seed").boundingBox()) ?? { width: 0, height: 1 };
    expect(width / height).toBeCloseTo(aspect, 1);
    await expect(page.getByRole("link", { name: "The river" })).toBeHidden();
    expect(await moved()).toBe(0);
  });
}

test("nothing moves on a page with twenty rivers that were copied from the Share dialog", async ({ page, blog }) => {
  const moved = await shifts(page);
  const picture = '<svg xmlns="http://www.w3.org/2000/svg" width="3000" height="2000"/>';
  const snippets = Array.from({ length: 20 }, (_, i) => {
    // A saved picture is far larger than its place; every other one was not saved.
    if (i % 2 === 0) blog.answer(`/${i}.svg`, { headers: { "content-type": "image/svg+xml" }, body: picture });
    const aspect = ["0.8", "1.5", "3"][i % 3] ?? "";
    const { link } = engine.readLink(`seed=${i}&attractors=300&aspect=${aspect}`);
    const snippet = elementSnippet({ link, seed: String(i), aspect, page: `${blog.origin}/` }, `${i}.svg`);
    return `<p>Text before river ${i}.</p><div style="width: 90px">${snippet}</div>`;
  });
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.setViewportSize({ width: 1280, height: 4000 });
  // As posts are seen on a slow line: the script comes when the page has been laid out.
  let answer = (): void => {};
  const held = new Promise<void>((done) => {
    answer = done;
  });
  await page.route("**/river-seed.js", async (route) => {
    await held;
    await route.continue();
  });
  const events = await listen(page);
  blog.answer("/", { body: post(snippets.join("")) });
  await page.goto(blog.origin, { waitUntil: "commit" });
  await expect(page.locator("river-seed")).toHaveCount(20);
  await frames(page, 5);
  answer();
  await heard(events, "complete", 20);
  await frames(page, 5);
  expect(await moved()).toBe(0);
});

test("what stands in the river's place is seen until there is one", async ({ page, blog }) => {
  let answer = (): void => {};
  const held = new Promise<void>((done) => {
    answer = done;
  });
  const events = await listen(page);
  await page.context().route("**/riverseed_label_bg.wasm", async (route) => {
    await held;
    await route.continue();
  });
  blog.headers = { "content-security-policy": "worker-src 'none'" };
  blog.answer("/", { body: post(`<river-seed attractors="300">${FALLBACK}</river-seed>`) });
  await page.goto(blog.origin);
  const fallback = page.getByRole("link", { name: "The river" });
  await page.waitForFunction(() => customElements.get("river-seed"));
  await frames(page);
  await expect(fallback).toBeVisible();
  answer();
  await heard(events, "ready");
  await expect(fallback).toBeHidden();
});

test("who prefers less motion sees the finished river, at once, and can still play it @core", async ({
  page,
  blog,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(page, blog, '<river-seed attractors="300" controls></river-seed>');
  await heard(events, "complete");
  const phases = (await events()).filter(({ type }) => type === "ready" || type === "complete").map(({ type }) => type);
  expect(phases).toEqual(["ready", "complete"]);
  const before = (await events()).length;
  await page.getByRole("button", { name: "Grow the rivers again" }).click();
  await expect(page.getByRole("button", { name: "Pause the rivers" })).toBeVisible();
  await heard(events, "complete", 2);
  expect((await events()).slice(before).map(({ type }) => type)).toContain("progress");
});

test("the preference is followed while it grows", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed attractors="400" controls></river-seed>');
  await heard(events, "progress");
  await page.getByRole("button", { name: "Pause the rivers" }).waitFor();
  await page.emulateMedia({ reducedMotion: "reduce" });
  await heard(events, "complete");
  await expectPicture(page, canonical("attractors=400"));
});

test("play, pause and restart do what they say, before there is a river as well", async ({ page, blog }) => {
  type RiverSeed = HTMLElementTagNameMap["river-seed"];
  const events = await open(page, blog, '<p style="height: 5000px"></p><river-seed attractors="300"></river-seed>');
  const river = page.locator("river-seed");
  await page.waitForFunction(() => customElements.get("river-seed"));
  await river.evaluate((river: RiverSeed) => river.pause());
  await river.scrollIntoViewIfNeeded();
  await heard(events, "ready");
  await expect(page.getByRole("button", { name: "Let the rivers grow" })).toBeVisible();
  await river.evaluate((river: RiverSeed) => river.play());
  await heard(events, "complete");
  await river.evaluate((river: RiverSeed) => river.restart());
  await heard(events, "complete", 2);
});

test("a box of another shape is covered by the map", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed attractors="300" still style="height: 120px"></river-seed>');
  await heard(events, "complete");
  await expectPicture(page, canonical("attractors=300"));
  const { height } = (await page.locator("river-seed canvas").boundingBox()) ?? { height: 0 };
  expect(height).toBe(120);
});

const backing = (page: Page, id: string): Promise<number[]> =>
  page.locator(`#${id} canvas`).evaluate((canvas: HTMLCanvasElement) => [canvas.width, canvas.height]);

/** How many bytes of the screen, inside a river's box, are not the ones that its canvas has there. */
async function differing(page: Page, scale: number): Promise<number> {
  const box = await page.locator("river-seed").boundingBox();
  if (!box) throw new Error("the river is nowhere");
  // A part that begins and ends with a pixel of the screen.
  const inside = (edge: number): number => 2 * Math.ceil(edge / 2) + 2;
  const part = { x: inside(box.x), y: inside(box.y), width: 300, height: 180 };
  const shot = (await page.screenshot({ clip: part })).toString("base64");
  return page.locator("river-seed canvas").evaluate(
    async (shown: HTMLCanvasElement, { shot, part, scale }) => {
      const bytes = Uint8Array.from(atob(shot), (sign) => sign.charCodeAt(0));
      const screen = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const { width, height } = screen;
      const bytesOf = (image: CanvasImageSource, x: number, y: number): Uint8ClampedArray => {
        const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
        context?.drawImage(image, -x, -y);
        return context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
      };
      const canvas = shown.getBoundingClientRect();
      const from = (part: number, canvas: number): number => part * scale - Math.round(canvas * scale);
      const expected = bytesOf(shown, from(part.x, canvas.x), from(part.y, canvas.y));
      return bytesOf(screen, 0, 0).filter((byte, i) => byte !== expected[i]).length;
    },
    { shot, part, scale },
  );
}

for (const transform of ["scale(.5)", "scale(0)", "rotate(30deg) scale(.4)"]) {
  test(`one that is drawn under ${transform} is sharp when that ends`, async ({ page, blog }) => {
    const river = (id: string): string =>
      `<river-seed id="${id}" attractors="300" still loading="eager" style="width: 333.4px"></river-seed>`;
    const body = `<div id="slide" style="transform: ${transform}; transform-origin: 0 0">${river("scaled")}</div>${river("plain")}`;
    const events = await open(page, blog, body);
    await heard(events, "complete", 2);
    await page.locator("#slide").evaluate((slide) => slide.style.removeProperty("transform"));
    await expectPicture(page, canonical("attractors=300"), "#scaled");
    expect(await backing(page, "scaled")).toEqual(await backing(page, "plain"));
  });
}

for (const [left, scale] of [
  [10.3, 1],
  [10.6, 1],
  [10.6, 1.5],
] as const) {
  test(`a box of fractions from ${left} shows the picture's own pixels, ${scale} to a CSS pixel`, async ({
    playwright,
    launchOptions,
    blog,
  }) => {
    // Emulated screens have their edges between the pixels.
    const args = [...(launchOptions.args ?? []), `--force-device-scale-factor=${scale}`];
    const browser = await playwright.chromium.launch({ ...launchOptions, args });
    const page = await browser.newPage({ viewport: null });
    const style = `width: 333.4px; margin-left: ${left}px`;
    const events = await open(
      page,
      blog,
      `<river-seed attractors="300" labels="none" still style="${style}"></river-seed>`,
    );
    await heard(events, "complete");
    await expectPicture(page, canonical("attractors=300&labels=none"));
    await frames(page, 5);
    expect(await differing(page, scale)).toBe(0);
    await browser.close();
  });
}

test("one that is drawn enlarged has the pixels that are seen", async ({ page, blog }) => {
  const body =
    '<river-seed id="large" attractors="300" still style="width: 300px; transform: scale(2); transform-origin: 0 0"></river-seed>';
  const events = await open(page, blog, body);
  await heard(events, "complete");
  expect(await backing(page, "large")).toEqual([600, 375]);
});

test("an author's style sheet has the last word", async ({ page, blog }) => {
  const style = `<style>river-seed { border-radius: 9px; --river-seed-button-background: rgb(1, 2, 3) }
    river-seed::part(button) { width: 60px } [hidden] { color: red }</style>`;
  const events = await open(page, blog, `${style}<river-seed attractors="300" controls></river-seed>`);
  await heard(events, "ready");
  await expect(page.getByRole("button")).toHaveCSS("background-color", "rgb(1, 2, 3)");
  await expect(page.getByRole("button")).toHaveCSS("width", "60px");
  await expect(page.locator("river-seed")).toHaveCSS("border-radius", "9px");
  await page.locator("river-seed").evaluate((river: HTMLElement) => {
    river.hidden = true;
  });
  await expect(page.locator("river-seed")).toBeHidden();
});

test.describe("labels", () => {
  for (const place of ["a worker", "the page"]) {
    test(`come with an engine of their own, and only if they are asked for: ${place}${core(place === "a worker")}`, async ({
      page,
      blog,
    }) => {
      if (place === "the page") blog.headers = { "content-security-policy": "worker-src 'none'" };
      const events = await listen(page);
      const attributes = 'seed="kauri" land="island" growth="drainage" attractors="1500" meander-rounds="5"';
      blog.answer("/", { body: post(`<river-seed ${attributes} labels="none"></river-seed>`) });
      await page.goto(blog.origin);
      await heard(events, "complete");
      expect(blog.asked).not.toContain("/widget/riverseed_label_bg.wasm");
      const picture = () =>
        page.locator("river-seed").evaluate(async (river: HTMLElementTagNameMap["river-seed"]) => {
          const blob = await river.toBlob({ longSide: 300 });
          return [...new Uint8Array(await blob.arrayBuffer())].length;
        });
      const bare = await picture();
      await page.locator("river-seed").evaluate((river) => river.setAttribute("labels", "many"));
      await expect.poll(() => blog.asked).toContain("/widget/riverseed_label_bg.wasm");
      await expect.poll(picture).not.toBe(bare);
    });
  }
});
