import { expect, test } from "@playwright/test";
import { complaints, finished, onDay } from "./riverpage.ts";
import { core } from "./tiers.ts";

const ENGINE = /\/riverseed_engine_bg[^/]*\.wasm$/;

for (const [visit, address] of [
  ["with a link", "./?attractors=300"],
  ["for the first time, on a slow line,", "./"],
] as const)
  test(`who comes ${visit} has the engine fetched once, and before its script has come${core(visit === "with a link")}`, async ({
    page,
  }) => {
    const said = complaints(page);
    const asked: string[] = [];
    page.on("request", (request) => asked.push(new URL(request.url()).pathname));
    let release = (): void => {};
    const held = new Promise<void>((done) => {
      release = done;
    });
    await page.route("**/*.js", async (route) => {
      await held;
      await route.continue();
    });
    const early = page.waitForResponse("**/riverseed_engine_bg*.wasm");
    await page.goto(address, { waitUntil: "commit" });
    await early;
    release();
    await finished(page);
    expect(asked.filter((path) => ENGINE.test(path))).toHaveLength(1);
    expect(said).toEqual([]);
  });

test("on a first visit the poster is asked for before the engine, which is fetched once", async ({ page }) => {
  const said = complaints(page);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await onDay(page);
  await page.goto("./");
  await finished(page);
  const orderOf = (name: RegExp): number => asked.findIndex((path) => name.test(path));
  expect(orderOf(/\/poster\//)).toBeGreaterThan(0);
  expect(orderOf(/\/poster\//)).toBeLessThan(orderOf(ENGINE));
  expect(asked.filter((path) => path.includes("/poster/"))).toHaveLength(1);
  expect(asked.filter((path) => ENGINE.test(path))).toHaveLength(1);
  expect(said).toEqual([]);
});

test("no style sheet holds up the worker or what stands behind it", async ({ page }) => {
  let release = (): void => {};
  const held = new Promise<void>((done) => {
    release = done;
  });
  await page.route("**/*.css", async (route) => {
    await held;
    await route.continue();
  });
  const worker = page.waitForRequest(/page-worker-[^/]*\.js$/);
  await page.goto("./", { waitUntil: "commit" });
  await worker;
  await page.waitForFunction(() => document.readyState !== "loading");
  release();
  await finished(page);
});

test("an embedded river fetches the engine once: its worker could not use what the document fetched early", async ({
  page,
}) => {
  const said = complaints(page);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.goto("./embed.html?attractors=300&labels=none");
  await expect(page.locator("html")).toHaveAttribute("data-state", "ready");
  expect(asked.filter((path) => path.endsWith(".wasm"))).toHaveLength(1);
  expect(said).toEqual([]);
});
