/** The rivers grow in a worker where there is one, and the page stays free; where there is none the page does the same. */

import { expect, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import {
  beforehand,
  complaints,
  countCalls,
  drawOnPage,
  expectPictureOfAddress,
  finished,
  openFinished,
  openSettings,
  shown,
  WORKER,
} from "./riverpage.ts";

const LINK = "seed=kauri&land=island&attractors=600&labels=some";

async function expectPicture(page: Page, link: string): Promise<void> {
  await finished(page);
  await expect
    .poll(async () => {
      const { width, height, sha256, framing } = await shown(page);
      return width > 100 && sha256 === pictureOf(link, width, height, framing).sha256;
    })
    .toBe(true);
}

test("the page's own thread makes and grows nothing: its worker does @core", async ({ page }) => {
  const said = complaints(page);
  const created = await countCalls(page, "river_new");
  const grown = await countCalls(page, "river_advance");
  const painted = await countCalls(page, "river_paint");
  await page.goto(`./?${LINK}`);
  await expectPicture(page, LINK);
  expect(page.workers().map((worker) => WORKER.test(worker.url()))).toEqual([true]);
  expect(await created()).toEqual({ onPage: 0, inWorker: 1 });
  for (const calls of [grown, painted]) {
    const { onPage, inWorker } = await calls();
    expect([onPage, inWorker > 10]).toEqual([0, true]);
  }
  // Its canvas is in the worker's hands.
  const isLent = await page.locator("#canvas").evaluate((canvas: HTMLCanvasElement) => {
    try {
      return canvas.getContext("2d") === null;
    } catch {
      return true;
    }
  });
  expect(isLent).toBe(true);
  expect(said).toEqual([]);
});

test("without a canvas for workers the page draws the same pixels, and asks for no worker @core", async ({ page }) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  await expectPicture(page, LINK);
  const inWorker = await shown(page);
  await drawOnPage(page);
  await page.reload();
  await expectPicture(page, LINK);
  expect(await shown(page)).toEqual(inWorker);
  expect(page.workers()).toEqual([]);
  expect(said).toEqual([]);
});

/** Has the page's worker answered otherwise. */
async function replaceWorker(page: Page, answer: { status?: number; body: string }): Promise<void> {
  await page.route(WORKER, (route) => route.fulfill({ contentType: "text/javascript", ...answer }));
}

for (const [what, answer] of [
  ["is not there", { status: 404, body: "" }],
  ["is no script", { body: "<h1>Hello</h1>" }],
  ["cannot start the engine", { body: "onmessage = () => postMessage({ is: 'shut' });" }],
  ["fails when it is spoken to", { body: "onmessage = () => { throw new Error('no') };" }],
] as const) {
  test(`where the worker's script ${what}, the page draws the same pixels`, async ({ page }) => {
    await replaceWorker(page, answer);
    await openFinished(page, LINK);
    await expectPicture(page, LINK);
    expect(page.workers()).toEqual([]);
    await expect(page.locator("#failure")).toBeHidden();
  });
}

test("where the page's policy refuses a worker, the page draws the same pixels", async ({ page }) => {
  await page.route("**/?*", async (route) => {
    const response = await route.fetch();
    const headers = { ...response.headers(), "content-security-policy": "worker-src 'none'" };
    await route.fulfill({ response, headers });
  });
  await openFinished(page, LINK);
  await expectPicture(page, LINK);
  expect(page.workers()).toEqual([]);
});

/** Lets the page's clock run, second by second, until something is so. */
async function until(page: Page, isSo: () => Promise<boolean>): Promise<void> {
  await expect
    .poll(async () => {
      await page.clock.runFor(1000);
      return isSo();
    })
    .toBe(true);
}

test("a worker that never speaks is given up, then another, and the page takes over", async ({ page }) => {
  await page.clock.install();
  await replaceWorker(page, { body: "onmessage = () => {};" });
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto(`./?${LINK}`);
  const frame = page.locator("#frame");
  await until(page, async () => (await frame.getAttribute("data-state")) === "finished");
  await expectPicture(page, LINK);
  expect(page.workers()).toEqual([]);
});

test("a worker that ends is replaced, and the river goes on in another, on a canvas that is as well described", async ({
  page,
}) => {
  const said = complaints(page);
  await page.clock.install();
  await beforehand(
    page,
    () => {
      if ("DedicatedWorkerGlobalScope" in globalThis) new BroadcastChannel("end").onmessage = () => globalThis.close();
    },
    undefined,
  );
  await openFinished(page, LINK);
  await expectPicture(page, LINK);
  const before = await shown(page);
  await page.evaluate(() => new BroadcastChannel("end").postMessage(""));
  await expect.poll(() => page.workers().length).toBe(0);
  // The picture stays until there is another.
  expect(await shown(page)).toEqual(before);
  await page.getByRole("button", { name: "Replay" }).click();
  await until(page, async () => page.workers().length === 1);
  await expect(page.getByRole("button", { name: "Replay" })).toBeVisible();
  await expectPicture(page, LINK);
  await expect(page.locator("#canvas")).toHaveCount(1);
  await expect(page.getByRole("img", { name: /seed “kauri”: \d+ rivers/ })).toBeVisible();
  await page.getByLabel("Seed", { exact: true }).fill("rimu");
  await page.getByLabel("Seed", { exact: true }).press("Enter");
  await expect(page.locator("#title")).toHaveText("rimu");
  await expectPictureOfAddress(page);
  expect(said).toEqual([]);
});

test("in a hidden tab the worker rests, and goes on when it is seen @core", async ({ page }) => {
  await page.goto("./?seed=miro&attractors=4000&meander-rounds=400&style=ink&labels=none");
  await finished(page);
  await openSettings(page);
  await page.getByRole("slider", { name: "Speed of growth" }).press("Home");
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  const hide = (hidden: boolean) =>
    page.evaluate((value) => {
      Object.defineProperty(document, "hidden", { configurable: true, value });
      document.dispatchEvent(new Event("visibilitychange"));
    }, hidden);
  await hide(true);
  const { sha256 } = await shown(page);
  for (let i = 0; i < 3; i++) expect((await shown(page)).sha256).toBe(sha256);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await hide(false);
  await page.getByRole("slider", { name: "Speed of growth" }).press("End");
  await expectPictureOfAddress(page);
});

test("what is said of the picture is of the river that was asked for last", async ({ page }) => {
  await page.addInitScript(() => {
    const seen: string[][] = [];
    Object.assign(globalThis, { said_: seen });
    new MutationObserver(() => {
      const said = document.querySelector("#canvas")?.ariaLabel?.split(": ")[1] ?? "";
      if (said.includes("Strahler")) seen.push([document.querySelector("#title")?.textContent ?? "", said]);
    }).observe(document, { subtree: true, childList: true, characterData: true, attributes: true });
  });
  await openFinished(page, "seed=one&attractors=9000&style=ink&labels=none");
  // The second is on its way when the others are asked for, at once.
  await page.evaluate(async () => {
    const form = document.querySelector<HTMLFormElement>("#seed-form");
    const box = document.querySelector<HTMLInputElement>("#seed");
    for (const seed of ["two", "three", "four"]) {
      if (box) box.value = seed;
      form?.requestSubmit();
      if (seed === "two") for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
    }
  });
  await expectPictureOfAddress(page);
  const said = await page.evaluate(() => (globalThis as unknown as { said_: string[][] }).said_);
  const { summary } = pictureOf("seed=four&attractors=9000", 16, 16);
  expect(said.at(-1)?.[1]).toContain(`${summary.mouths} rivers`);
  const first = pictureOf("seed=one&attractors=9000&style=ink&labels=none", 16, 16).summary;
  const counts = said.filter(([title]) => title === "four").map(([, caption = ""]) => caption.split(",")[0]);
  // Until there is word of it, what was said before stays: of the first, never of those between.
  for (const count of counts) expect([`${first.mouths} rivers`, `${summary.mouths} rivers`]).toContain(count);
});
