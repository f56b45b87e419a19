/** What never answers is given up, also when it answered before. The clock is faked: nothing here waits. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { type Answer, BUILT, expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, type Heard, heard, listen, post } from "./post.ts";

const ENGINE = "/widget/riverseed_label_bg.wasm";
const WORKER = "/widget/worker.js";
const HERE = "/widget/tag-page-backend.js";
const SCRIPT = { "content-type": "text/javascript" };

type RiverSeed = HTMLElementTagNameMap["river-seed"];

const widget = (id: string, attributes = 'attractors="300" still'): string =>
  `<river-seed id="${id}" seed="${id}" ${attributes} loading="eager" style="width: 300px; float: left"><a href="#${id}">River ${id}</a></river-seed>`;

/** So many rounds that no test sees the end of them. */
const LONG = 'meander-rounds="400" trim="0"';

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  await page.clock.install();
  await page.addInitScript(() => {
    const count = { begun: 0, ended: 0 };
    Object.assign(globalThis, { workers_: count });
    globalThis.Worker = class extends Worker {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        count.begun++;
      }
      override terminate(): void {
        count.ended++;
        super.terminate();
      }
    };
  });
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

/** Lets the page's clock run, second by second, until something is so. */
async function until(page: Page, isSo: () => boolean | Promise<boolean>): Promise<void> {
  await expect
    .poll(async () => {
      await page.clock.runFor(1000);
      return isSo();
    })
    .toBe(true);
}

/** How many workers the page has begun, and how many it has ended: known at once, whatever they do themselves. */
const workers = (page: Page): Promise<{ begun: number; ended: number }> =>
  page.evaluate(() => (globalThis as unknown as { workers_: { begun: number; ended: number } }).workers_);

const timesAsked = (blog: Host, path: string): number => blog.asked.filter((asked) => asked === path).length;

/** Adds a widget to the page as it is. */
async function add(page: Page, html: string): Promise<void> {
  await page.evaluate((html) => document.querySelector("main")?.insertAdjacentHTML("beforeend", html), html);
}

const expectRiver = (page: Page, id: string): Promise<void> =>
  expectPicture(page, canonical(`seed=${id}&attractors=300`), `#${id}`);

/** The engine, which the server does not send, is asked for and given up in a worker, then on the page. */
async function giveUpTwice(page: Page, blog: Host, events: () => Promise<Heard[]>): Promise<void> {
  await expect.poll(() => timesAsked(blog, ENGINE)).toBe(1);
  await until(page, async () => (await workers(page)).ended === 1);
  await expect.poll(() => timesAsked(blog, ENGINE)).toBe(2);
  await until(page, async () => (await events()).length > 0);
}

test("an engine that never comes is given up by name, and a new try finds it @core", async ({ page, blog }) => {
  blog.answer(ENGINE, { hangs: true });
  const events = await open(page, blog, widget("rimu"));
  const river = page.locator("#rimu");
  await page.waitForFunction(() => customElements.get("river-seed"));
  const blob = river.evaluate((river: RiverSeed) =>
    river.toBlob().then(
      () => "a picture",
      ({ code }) => code,
    ),
  );
  // First in a worker, then on the page.
  await giveUpTwice(page, blog, events);
  expect(await events()).toMatchObject([
    {
      type: "error",
      detail: { code: "wasm-timeout", advice: expect.stringContaining("Check the connection") },
    },
  ]);
  expect(await blob).toBe("wasm-timeout");
  expect(timesAsked(blog, ENGINE)).toBe(2);
  await expect(page.getByRole("link", { name: "River rimu" })).toBeVisible();
  // Said once, however long one waits.
  await page.clock.runFor(120_000);
  expect(await events()).toHaveLength(1);
  blog.forget(ENGINE);
  await river.evaluate((river: RiverSeed) => river.restart());
  await heard(events, "complete");
  await expectRiver(page, "rimu");
});

test("an engine that stops half-way is given up, and a later widget tries again", async ({ page, blog }) => {
  const half = readFileSync(join(BUILT, "riverseed_label_bg.wasm")).subarray(0, 60_000);
  blog.answer(ENGINE, { body: half, hangs: true });
  const events = await open(page, blog, widget("rimu"));
  await giveUpTwice(page, blog, events);
  expect(await heard(events, "error")).toMatchObject({ id: "rimu", detail: { code: "wasm-timeout" } });
  blog.forget(ENGINE);
  await add(page, widget("miro"));
  await heard(events, "complete");
  await expectRiver(page, "miro");
});

for (const file of ["riverseed_engine_bg.wasm", "tag-whole.js"]) {
  test(`an engine that never comes for a file is given up by name, and the river stays: ${file}`, async ({
    page,
    blog,
  }) => {
    blog.headers = { "content-security-policy": "worker-src 'none'" };
    blog.answer(`/widget/${file}`, { hangs: true });
    const events = await open(page, blog, widget("rimu"));
    await heard(events, "complete");
    const river = page.locator("#rimu");
    await river.evaluate((river: RiverSeed) => {
      void river.toSVG().catch(({ code, message }) => Object.assign(globalThis, { said: `${code}: ${message}` }));
    });
    await until(page, () => page.evaluate(() => "said" in globalThis));
    expect(await page.evaluate(() => Reflect.get(globalThis, "said"))).toMatch(/^wasm-timeout: nothing came/);
    await expectRiver(page, "rimu");
    // A script that hangs, a browser does not ask for again.
    if (file.endsWith(".js")) return;
    blog.forget(`/widget/${file}`);
    expect(await river.evaluate((river: RiverSeed) => river.toSVG())).toContain("<svg");
  });
}

const SILENT: [what: string, answer: Answer][] = [
  ["never comes", { hangs: true }],
  ["comes empty", { headers: SCRIPT, body: "" }],
  ["loops", { headers: SCRIPT, body: "for (;;);" }],
  ["loops when it is spoken to", { headers: SCRIPT, body: "onmessage = () => { for (;;); }" }],
  ["never speaks", { headers: SCRIPT, body: "onmessage = () => {};" }],
];

for (const [what, answer] of SILENT) {
  test(`a worker whose script ${what} is given up, and the page itself grows the rivers`, async ({ page, blog }) => {
    blog.answer(WORKER, answer);
    const events = await open(page, blog, widget("rimu") + widget("miro"));
    await until(page, async () => (await workers(page)).ended === 1);
    await heard(events, "complete", 2);
    expect(blog.asked).toContain(HERE);
    await expectRiver(page, "rimu");
    await expectRiver(page, "miro");
    await add(page, widget("kauri"));
    await heard(events, "complete", 3);
    await expectRiver(page, "kauri");
    expect((await events()).map(({ type }) => type)).not.toContain("error");
  });
}

test("where the page's own part does not come either, that is said by name", async ({ page, blog }) => {
  blog.answer(WORKER, { headers: SCRIPT, body: "" });
  blog.answer(HERE, { hangs: true });
  const events = await open(page, blog, widget("rimu"));
  await until(page, async () => (await events()).length > 0);
  // The advice is in the part that did not come.
  expect(await events()).toMatchObject([{ type: "error", detail: { code: "wasm-timeout", advice: "" } }]);
  await expect(page.getByRole("link", { name: "River rimu" })).toBeVisible();
});

/** A worker that can be told to end, as browsers end some. */
const MORTAL = `new BroadcastChannel("end").onmessage = () => self.close();
${readFileSync(join(BUILT, "worker.js"), "utf8")}`;

async function endWorker(page: Page): Promise<void> {
  await page.evaluate(() => new BroadcastChannel("end").postMessage(""));
  await expect.poll(() => page.workers().length).toBe(0);
}

/** Waits until each of these has gone on since it had sent that number of events. */
async function expectProgress(events: () => Promise<Heard[]>, since: number, ids: string[]): Promise<void> {
  for (const id of ids) {
    const isHeard = async () =>
      (await events()).slice(since).some((event) => event.id === id && event.type !== "error");
    await expect.poll(isHeard).toBe(true);
  }
}

test("a worker that ends later is replaced: all go on, and what was asked of it meanwhile is done", async ({
  page,
  blog,
}) => {
  blog.answer(WORKER, { headers: SCRIPT, body: MORTAL });
  const ids = ["rimu", "miro", "kauri"];
  const events = await open(page, blog, ids.map((id) => widget(id, LONG)).join(""));
  await expectProgress(events, 0, ids);
  await endWorker(page);
  const since = (await events()).length;
  // A restart, a changed attribute, a new widget, and a file.
  await page.locator("#rimu").evaluate((river: RiverSeed) => river.restart());
  await page.locator("#miro").evaluate((river: RiverSeed) => {
    for (const [key, value] of Object.entries({ attractors: "300", still: "" })) river.setAttribute(key, value);
    for (const key of ["meander-rounds", "trim"]) river.removeAttribute(key);
  });
  await add(page, widget("matai"));
  const blob = page.locator("#miro").evaluate(async (river: RiverSeed) => (await river.toBlob()).type);
  await until(page, async () => (await workers(page)).begun === 2);
  await expectProgress(events, since, ["rimu", "kauri"]);
  await expectRiver(page, "miro");
  await expectRiver(page, "matai");
  expect(await blob).toBe("image/png");
  // A second one that ends is the last that is tried.
  await endWorker(page);
  await until(page, async () => (await workers(page)).ended === 2);
  await page.locator("#miro").evaluate((river) => river.setAttribute("seed", "totara"));
  await expectPicture(page, canonical("seed=totara&attractors=300"), "#miro");
  await add(page, widget("tawa"));
  await expectRiver(page, "tawa");
  expect(await workers(page)).toEqual({ begun: 2, ended: 2 });
  expect((await events()).map(({ type }) => type)).not.toContain("error");
});

test("a finished river's worker is missed when something is asked of it, and a replay is a replay", async ({
  page,
  blog,
}) => {
  blog.answer(WORKER, { headers: SCRIPT, body: MORTAL });
  const events = await open(page, blog, widget("rimu", 'attractors="300"'));
  await heard(events, "complete");
  await endWorker(page);
  // While a river grows before one's eyes, its button is not a quiet one.
  await expect(page.getByRole("button")).toHaveClass(/quiet/);
  await page.getByRole("button").evaluate((element) => {
    const note = (): void => {
      if (!element.classList.contains("quiet")) document.body.dataset["grew"] = "again";
    };
    new MutationObserver(note).observe(element, { attributeFilter: ["class"] });
  });
  await page.locator("#rimu").evaluate((river: RiverSeed) => river.restart());
  await until(page, async () => (await workers(page)).begun === 2);
  await heard(events, "complete", 2);
  await expect(page.locator("body")).toHaveAttribute("data-grew", "again");
});

/** A worker that stops in the middle of painting a picture for a file, until a request is answered. */
const HOLDING = `globalThis.CompressionStream = class extends CompressionStream {
  constructor(...format) {
    super(...format);
    const request = new XMLHttpRequest();
    request.open("GET", "/painting", false);
    request.send();
  }
};
${readFileSync(join(BUILT, "worker.js"), "utf8")}`;

test("a worker that paints a large picture is waited for, though it says nothing for a minute", async ({
  page,
  blog,
}) => {
  blog.answer(WORKER, { headers: SCRIPT, body: HOLDING });
  let answer = (): void => {};
  const held = new Promise<void>((done) => {
    answer = done;
  });
  let isPainting = false;
  await page.context().route("**/painting", async (route) => {
    isPainting = true;
    await held;
    await route.fulfill({ body: "" });
  });
  const events = await open(page, blog, widget("rimu"));
  await heard(events, "complete");
  const type = page.locator("#rimu").evaluate(async (river: RiverSeed) => (await river.toBlob()).type);
  await until(page, () => isPainting);
  for (let second = 0; second < 60; second++) await page.clock.runFor(1000);
  expect(await workers(page)).toEqual({ begun: 1, ended: 0 });
  answer();
  expect(await type).toBe("image/png");
  expect(await workers(page)).toEqual({ begun: 1, ended: 0 });
});
