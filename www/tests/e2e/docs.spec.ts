/** The documentation, as it was built. */

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Page } from "@playwright/test";
import { indexOf } from "../../src/apps/docs/index.ts";
import { violations } from "./axe.ts";
import { openElsewhere } from "./elsewhere.ts";
import { complaints } from "./riverpage.ts";
import { core } from "./tiers.ts";
import { expect, test } from "./widget/hosts.ts";

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));

async function ask(page: Page, question: string): Promise<void> {
  await page.keyboard.press("/");
  await expect(page.getByRole("searchbox", { name: "Search the documentation" })).toBeFocused();
  await page.keyboard.type(question);
}

test("with the keyboard alone one finds a section and goes there; the index comes when it is asked for @core", async ({
  page,
}) => {
  const said = complaints(page);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.goto("./docs/for/teachers.html");
  await expect(page.getByRole("searchbox")).toBeVisible();
  expect(asked.filter((path) => path.endsWith(".json"))).toEqual([]);
  await ask(page, "bifurcation ratio");
  const results = page.getByRole("list", { name: "Results" }).getByRole("link");
  const measures = results.and(page.getByRole("link", { name: "Measures · Algorithms" }));
  await expect(measures).toBeVisible();
  await expect(page.getByRole("status")).toHaveText(/^\d+ results$/);
  await page.keyboard.press("ArrowDown");
  await expect(results.first()).toBeFocused();
  await page.keyboard.press("ArrowUp");
  await expect(page.getByRole("searchbox")).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(results).toHaveCount(0);
  await page.keyboard.type("bifurcation ratio");
  await expect(measures).toBeVisible();
  for (let i = 0; i < 12 && !(await measures.evaluate((link) => link === document.activeElement)); i++)
    await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await expect(page).toHaveURL(/\/docs\/algorithms\.html#measures$/);
  await expect(page.getByRole("heading", { name: "Measures" })).toBeInViewport();
  expect(said).toEqual([]);
});

test("Enter in the field opens the first result", async ({ page }) => {
  await page.goto("./docs/");
  await ask(page, "exit codes");
  await expect(page.getByRole("list", { name: "Results" }).getByRole("link").first()).toBeVisible();
  await page.keyboard.press("Enter");
  await expect(page).toHaveURL(/\/docs\/command-line\.html#exit-codes$/);
});

/** The kinds of elements in what was found. */
function kindsFound(page: Page): Promise<string[]> {
  return page.evaluate(() => [
    ...new Set([...document.querySelectorAll(".found *")].map(({ localName }) => localName)),
  ]);
}

for (const question of ["<qqqqzzzz>", "<img src=x onerror=alert(1)>", "../../etc/passwd", "‮abc‬"])
  test(`a question is read neither as HTML nor as a path: ${question}`, async ({ page }) => {
    const said = complaints(page);
    await page.goto("./docs/");
    await ask(page, question);
    await expect(page.getByRole("status")).not.toBeEmpty();
    expect(["ul", "li", "a", "span", "mark", "p"]).toEqual(expect.arrayContaining(await kindsFound(page)));
    for (const link of await page.getByRole("list", { name: "Results" }).getByRole("link").all())
      expect(await link.evaluate((a: HTMLAnchorElement) => a.pathname)).toMatch(/^\/docs\/[\w/-]+\.html$/);
    expect(said).toEqual([]);
  });

test("what was found is text, whatever stands in it, and leads to a page of the site", async ({ page }) => {
  const said = complaints(page);
  const text = "word <img src=x onerror=alert(1)> and <script>alert(1)</script>";
  const hostile = { address: "javascript:alert(1)", page: "<b>page</b>", heading: "<i>heading</i>", text, code: "" };
  await page.route("**/search.json", (route) => route.fulfill({ body: indexOf([hostile]) }));
  await page.goto("./docs/");
  await ask(page, "word");
  const link = page.getByRole("list", { name: "Results" }).getByRole("link");
  await expect(link).toContainText(text);
  expect(["ul", "li", "a", "span", "mark", "p"]).toEqual(expect.arrayContaining(await kindsFound(page)));
  expect(await link.evaluate((a: HTMLAnchorElement) => a.protocol)).toBe("http:");
  expect(said).toEqual([]);
});

test("if the index cannot be fetched, that is said, and it is asked for again", async ({ page }) => {
  let isAway = true;
  await page.route("**/search.json", (route) => (isAway ? route.abort() : route.continue()));
  await page.goto("./docs/");
  await ask(page, "oxbow");
  await expect(page.getByRole("status")).toContainText("could not be loaded");
  isAway = false;
  await page.keyboard.type(" lake");
  // A request that failed while this was typed answers it; the next key asks again.
  await expect(async () => {
    await page.keyboard.press("Space");
    await expect(page.getByRole("list", { name: "Results" }).getByRole("link").first()).toBeVisible({ timeout: 5000 });
  }).toPass();
});

for (const colorScheme of ["light", "dark"] as const)
  for (const address of ["docs/", "docs/for/bloggers.html", "docs/glossary.html"])
    test(`axe finds nothing, and nothing is said or cut off: ${address}, ${colorScheme}${core(colorScheme === "light")}`, async ({
      page,
    }) => {
      const said = complaints(page);
      await page.emulateMedia({ colorScheme });
      for (const width of [1440, 360]) {
        await page.setViewportSize({ width, height: 800 });
        await page.goto(`./${address}`);
        await ask(page, "river");
        await expect(page.getByRole("list", { name: "Results" }).getByRole("link").first()).toBeVisible();
        expect(await violations(page)).toEqual([]);
        await page.keyboard.press("Escape");
        expect(await violations(page)).toEqual([]);
        expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      }
      expect(said).toEqual([]);
    });

test("without scripts there is all but the search", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, ...(baseURL && { baseURL }) });
  const page = await context.newPage();
  await page.goto("./docs/for/novelists.html");
  await expect(page.getByRole("searchbox")).toBeHidden();
  await expect(page.locator("noscript > p")).toBeVisible();
  await page.getByRole("navigation", { name: "Contents" }).getByRole("link", { name: "Glossary" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Glossary");
  await context.close();
});

test("what bloggers paste grows on another site", async ({ page, blog, baseURL, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("./docs/for/bloggers.html");
  const first = page.locator(".code").first();
  await first.getByRole("button", { name: "Copy" }).click();
  await expect(first.getByRole("button", { name: "Copied" })).toBeVisible();
  await expect(page.locator("noscript")).toBeHidden();
  const snippet = await page.evaluate(() => navigator.clipboard.readText());
  expect(snippet).toContain(`src="${baseURL}widget/river-seed.js"`);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await openElsewhere({ page, blog, baseURL }, snippet);
  await expect(page.locator("river-seed canvas")).toBeVisible();
  const finished = await page
    .locator("river-seed")
    .evaluate(async (river) => (await (river as unknown as { finished: Promise<{ link: string }> }).finished).link);
  expect(finished).toContain("seed=skye");
});

test("an address to paste opens on the page", async ({ page, baseURL }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./docs/for/novelists.html");
  const first = page.locator(".code").first();
  await expect(first.locator("code")).toHaveText(new RegExp(`^${baseURL}\\?seed=rimu&`));
  await first.getByRole("link", { name: "Open it" }).click();
  await expect(page.getByRole("textbox", { name: "Seed" })).toHaveValue("rimu");
});

test("the documentation is no part of what the page keeps for visits without a connection", () => {
  const worker = readFileSync(`${DIST}service-worker.js`, "utf8");
  expect(worker).toContain("index.html");
  expect(worker).not.toMatch(/docs[/-]/);
});
