import type { Page } from "@playwright/test";
import { expect, type Host, test } from "./hosts.ts";
import {
  canonical,
  expectPicture,
  failOnReplay,
  type Heard,
  heard,
  listen,
  PROBE,
  PROBED_WORKER,
  post,
} from "./post.ts";

const FALLBACK = '<img alt="A river" src="data:image/gif;base64,R0lGODlhAQABAAAAACw="><a href="#river">The river</a>';
const WIDGET = `<river-seed seed="rimu" attractors="300" still>${FALLBACK}</river-seed>`;
const ENGINE = "/widget/riverseed_label_bg.wasm";

async function open(page: Page, blog: Host, body = WIDGET): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

/** The failure has its name, and what the author put in the picture's place is there for good. */
async function expectFailure(page: Page, events: () => Promise<Heard[]>, code: string, advice: RegExp): Promise<void> {
  const { detail } = await heard(events, "error");
  expect(detail).toMatchObject({ code, advice: expect.stringMatching(advice) });
  await expect(page.getByRole("link", { name: "The river" })).toBeVisible();
  await expect(page.locator("river-seed canvas")).toHaveCount(0);
  expect((await events()).map(({ type }) => type)).toEqual(["error"]);
}

test("the engine's file is missing: the fallback stays, and a new try finds it @core", async ({ page, blog }) => {
  blog.answer(ENGINE, { status: 404, headers: { "content-type": "text/html" }, body: "not here" });
  const events = await open(page, blog);
  await expectFailure(page, events, "file-missing", /\.wasm files beside the scripts/);
  blog.forget(ENGINE);
  await page.locator("river-seed").evaluate((river: HTMLElementTagNameMap["river-seed"]) => river.restart());
  await heard(events, "complete");
  await expectPicture(page, canonical("seed=rimu&attractors=300"));
  await expect(page.getByRole("link", { name: "The river" })).toBeHidden();
});

test("a server that answers with a page of its own", async ({ page, blog }) => {
  blog.answer(ENGINE, { headers: { "content-type": "text/html" }, body: "<h1>Hello</h1>" });
  await expectFailure(page, await open(page, blog), "wasm-mime", /application\/wasm/);
});

test("the right bytes under the wrong type still grow", async ({ page, blog }) => {
  blog.types[".wasm"] = "application/octet-stream";
  const events = await open(page, blog);
  await heard(events, "complete");
});

test("an engine on another origin that does not allow it", async ({ page, blog, cdn }) => {
  cdn.headers = {};
  const events = await open(
    page,
    blog,
    WIDGET.replace("<river-seed", `<river-seed wasm-url="${cdn.origin}/riverseed_bg.wasm"`),
  );
  await expectFailure(page, events, "wasm-fetch", /Check the connection/);
});

test("an engine on another origin that does", async ({ page, blog, cdn }) => {
  const url = `${cdn.origin}/riverseed_bg.wasm`;
  const events = await open(page, blog, WIDGET.replace("<river-seed", `<river-seed wasm-url="${url}"`));
  await heard(events, "complete");
  expect(blog.asked).not.toContain(ENGINE);
});

test("a policy that forbids WebAssembly", async ({ page, blog }) => {
  blog.headers = { "content-security-policy": "script-src 'self'" };
  await expectFailure(page, await open(page, blog), "wasm-csp", /wasm-unsafe-eval/);
});

for (const [what, style, fallback] of [
  ["its fallback", "", '<a href="#river">The river</a>'],
  [
    "its fallback, though its author reserved the river's room",
    "display:block;aspect-ratio:1.5;min-height:0",
    "<a>River</a>",
  ],
  ["a line of text where there is no fallback", "", ""],
] as const) {
  test(`a river that cannot be is as high as ${what}`, async ({ page, blog }) => {
    blog.headers = { "content-security-policy": "script-src 'self'" };
    const events = await open(page, blog, `<river-seed style="${style}">${fallback}</river-seed>`);
    await heard(events, "error");
    const { width, height } = (await page.locator("river-seed").boundingBox()) ?? { width: 0, height: 1000 };
    expect(width).toBeGreaterThan(1000);
    expect(height).toBeGreaterThan(10);
    expect(height).toBeLessThan(100);
  });
}

test("a river that cannot be leaves no room, one that then can has its room back @core", async ({ page, blog }) => {
  blog.answer(ENGINE, { status: 404 });
  const events = await open(page, blog, WIDGET);
  await heard(events, "error");
  blog.forget(ENGINE);
  await page.locator("river-seed").evaluate((river: HTMLElementTagNameMap["river-seed"]) => river.restart());
  await heard(events, "complete");
  const { width, height } = (await page.locator("river-seed").boundingBox()) ?? { width: 0, height: 1 };
  expect(width / height).toBeCloseTo(1.6, 2);
});

test("a browser without SIMD downloads no engine", async ({ page, blog }) => {
  await page.addInitScript(() => {
    WebAssembly.validate = () => false;
    Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen");
  });
  await expectFailure(page, await open(page, blog), "wasm-unsupported", /Safari 17\.2/);
  expect(blog.asked).not.toContain(ENGINE);
});

test("without a fallback a line says that there is nothing", async ({ page, blog }) => {
  blog.answer(ENGINE, { status: 404 });
  await open(page, blog, "<river-seed></river-seed>");
  await expect(page.getByText("This river cannot be shown.")).toBeVisible();
});

test("it is said once: on the console, unless the page says that it has heard", async ({ page, blog }) => {
  const warnings: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "warning") warnings.push(message.text());
  });
  blog.answer(ENGINE, { status: 404 });
  const events = await open(page, blog);
  await heard(events, "error");
  await expect.poll(() => warnings).toEqual([expect.stringMatching(/^river-seed: file-missing: .*404/)]);
  await page.evaluate(() => {
    document.addEventListener("error", (event) => event.preventDefault(), true);
    document.querySelector("river-seed")?.restart();
  });
  await heard(events, "error", 2);
  expect(warnings).toHaveLength(1);
});

const TWO = ["one", "two"]
  .map((id) => `<river-seed id="${id}" seed="${id}" attractors="300" style="width: 300px">${FALLBACK}</river-seed>`)
  .join("");

/** The engine stops in the first of the two, which has its fallback back. */
async function stopInOne(page: Page, events: () => Promise<Heard[]>): Promise<void> {
  await failOnReplay(page, "panic");
  await page.evaluate(() => document.querySelector<HTMLElementTagNameMap["river-seed"]>("#one")?.restart());
  expect(await heard(events, "error")).toMatchObject({ id: "one", detail: { code: "panic" } });
  await expect(page.locator("#one a")).toBeVisible();
}

test("without a worker the others go on in the same engine", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.addInitScript(PROBE);
  blog.headers = { "content-security-policy": "worker-src 'none'" };
  const events = await open(page, blog, TWO);
  await heard(events, "complete", 2);
  await stopInOne(page, events);
  await page.locator("#two").evaluate((two) => two.setAttribute("seed", "three"));
  await expectPicture(page, canonical("seed=three&attractors=300"), "#two");
  expect((await events()).filter(({ type }) => type === "error")).toHaveLength(1);
});

test("a finished river does not grow again in the engine that replaces one", async ({ page, blog }) => {
  blog.answer("/widget/worker.js", { headers: { "content-type": "text/javascript" }, body: PROBED_WORKER });
  const events = await open(page, blog, TWO);
  await heard(events, "complete", 2);
  // While a river grows before one's eyes, its button is not a quiet one.
  const button = page.locator("#two").getByRole("button");
  await expect(button).toHaveClass(/quiet/);
  await button.evaluate((element) => {
    const note = (): void => {
      if (!element.classList.contains("quiet")) document.body.dataset["grew"] = "again";
    };
    new MutationObserver(note).observe(element, { attributeFilter: ["class"] });
  });
  await stopInOne(page, events);
  await heard(events, "complete", 3);
  expect(await page.locator("body").getAttribute("data-grew")).toBeNull();
});

test("an engine that stops in one river is replaced for the others", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  blog.answer("/widget/worker.js", { headers: { "content-type": "text/javascript" }, body: PROBED_WORKER });
  const events = await open(page, blog, TWO);
  await heard(events, "complete", 2);
  const [before] = page.workers();
  await stopInOne(page, events);
  await expect.poll(() => page.workers().length === 1 && page.workers()[0] !== before).toBe(true);
  await expectPicture(page, canonical("seed=two&attractors=300"), "#two");
  // The other goes on in the new engine: it can still change.
  await page.locator("#two").evaluate((two) => two.setAttribute("seed", "three"));
  await expectPicture(page, canonical("seed=three&attractors=300"), "#two");
  // And so can the one that failed, when it is asked for something else.
  await page.locator("#one").evaluate((one) => one.setAttribute("seed", "four"));
  await expectPicture(page, canonical("seed=four&attractors=300"), "#one");
});

for (const place of ["a worker", "the page"]) {
  test(`memory that runs out is said by name, and nothing half-made stays: ${place}`, async ({ page, blog }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    if (place === "the page") {
      await page.addInitScript(PROBE);
      blog.headers = { "content-security-policy": "worker-src 'none'" };
    } else blog.answer("/widget/worker.js", { headers: { "content-type": "text/javascript" }, body: PROBED_WORKER });
    const events = await open(page, blog, TWO);
    await heard(events, "complete", 2);
    await failOnReplay(page, "no-memory");
    const one = page.locator("#one");
    await one.evaluate((river: HTMLElementTagNameMap["river-seed"]) => river.restart());
    const advice = expect.stringMatching(/fewer attractors/);
    expect(await heard(events, "error")).toMatchObject({ id: "one", detail: { code: "no-memory", advice } });
    await expect(one.locator("a")).toBeVisible();
    await expect(one.locator("canvas")).toHaveCount(0);
    // The engine is sound: the other river goes on, and this one may be something smaller.
    await page.locator("#two").evaluate((two) => two.setAttribute("seed", "three"));
    await expectPicture(page, canonical("seed=three&attractors=300"), "#two");
    await one.evaluate((one) => one.setAttribute("seed", "four"));
    await expectPicture(page, canonical("seed=four&attractors=300"), "#one");
    expect((await events()).filter(({ type }) => type === "error")).toHaveLength(1);
  });
}
