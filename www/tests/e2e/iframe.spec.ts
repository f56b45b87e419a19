import type { Page } from "@playwright/test";
import { violations } from "./axe.ts";
import { type Elsewhere, openElsewhere, showsRiver } from "./elsewhere.ts";
import { complaints, openFinished } from "./riverpage.ts";
import { expect, test } from "./widget/hosts.ts";

const LINK = "seed=kowhai&attractors=300&curl=0.6&style=ink&labels=none";

test.use({ reducedMotion: "reduce", permissions: ["clipboard-read", "clipboard-write"] });

/** Opens a page elsewhere with an iframe of the river. */
async function openFramed(elsewhere: Elsewhere, { query = LINK, more = "" } = {}): Promise<void> {
  const iframe = `<iframe src="SITE/embed.html?${query}" title="Rivers" width="480" height="320" style="border:0"></iframe>`;
  await openElsewhere(elsewhere, iframe + more);
  const frame = elsewhere.page.frameLocator("iframe").first();
  await expect(frame.locator(":root")).toHaveAttribute("data-state", "ready");
}

/** Notes what the page around hears from its frames. Call before anything is opened. */
async function heights(page: Page): Promise<() => Promise<number[]>> {
  await page.addInitScript(() => {
    const heard: number[] = [];
    Object.assign(globalThis, { heard });
    if (window.parent === window) window.addEventListener("message", ({ data }) => heard.push(data.riverseed?.height));
  });
  return () => page.evaluate(() => (globalThis as unknown as { heard: number[] }).heard);
}

/** Sends a message to the first frame from the page around it. */
function post(page: Page, message: unknown): Promise<void> {
  return page.evaluate(
    (message) => document.querySelector("iframe")?.contentWindow?.postMessage(message, "*"),
    message,
  );
}

/** In a frame the heading is the page's around it: one more would only stand in its readers' way. */
async function violationsInFrame(page: Page): Promise<string[]> {
  return (await violations(page)).filter((found) => !found.startsWith("page-has-heading-one"));
}

const river = (page: Page) => page.frameLocator("iframe").first().locator("river-seed");

test("the iframe that Share copies draws the same river on another origin @core", async ({ page, blog, baseURL }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByRole("radio", { name: "Blog" }).check();
  await page.getByText("My blog allows no scripts").click();
  await page.getByRole("button", { name: "Copy iframe" }).click();
  await expect(page.getByRole("dialog").getByRole("status")).toHaveText("Iframe copied.");
  const snippet = await page.evaluate(() => navigator.clipboard.readText());
  const said = complaints(page);
  await openElsewhere({ page, blog, baseURL }, `<div style="width:480px">${snippet}</div>`);
  await expect.poll(() => showsRiver(page, page.locator("iframe"), LINK)).toBe(true);
  expect(said).toEqual([]);
});

test("the element that Share copies draws the same river on another origin", async ({ page, blog, baseURL }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByRole("radio", { name: "Blog" }).check();
  await page.getByRole("button", { name: "Copy snippet" }).click();
  await expect(page.getByRole("dialog").getByRole("status")).toHaveText("Snippet copied.");
  const snippet = await page.evaluate(() => navigator.clipboard.readText());
  await openElsewhere({ page, blog, baseURL }, `<div style="width:480px">${snippet}</div>`);
  await expect.poll(() => showsRiver(page, page.locator("river-seed"), LINK)).toBe(true);
});

test("the page around is told the height that fits, once, and again when the width changes", async ({
  page,
  blog,
  baseURL,
}) => {
  const heard = await heights(page);
  await openFramed({ page, blog, baseURL });
  await expect.poll(heard).toEqual([300]);
  const iframe = page.locator("iframe");
  await iframe.evaluate((frame) => frame.setAttribute("height", "700"));
  await iframe.evaluate((frame) => frame.setAttribute("width", "600"));
  await expect.poll(heard).toEqual([300, 375]);
});

test("with the host script an iframe is as high as its river @core", async ({ page, blog, baseURL }) => {
  await openFramed(
    { page, blog, baseURL },
    { query: `${LINK}&aspect=2`, more: `<script src="SITE/embed-host.js"></script>` },
  );
  const iframe = page.locator("iframe");
  await expect(iframe).toHaveCSS("height", "240px");
  await iframe.evaluate((frame) => frame.setAttribute("width", "600"));
  await expect(iframe).toHaveCSS("height", "300px");
});

test("the host script hands over the theme, at first and when it changes", async ({ page, blog, baseURL }) => {
  await openElsewhere(
    { page, blog, baseURL },
    `<iframe src="SITE/embed.html?${LINK}" data-theme="dark" title="Rivers"></iframe>
     <script src="SITE/embed-host.js"></script>`,
  );
  await expect(river(page)).toHaveAttribute("theme", "dark");
  await page.locator("iframe").evaluate((frame) => frame.setAttribute("data-theme", "light"));
  await expect(river(page)).toHaveAttribute("theme", "light");
  // The frame has the page's scheme, whatever its reader likes: with another one its ground would not be transparent.
  const scheme = () =>
    page
      .frameLocator("iframe")
      .locator("html")
      .evaluate((root) => getComputedStyle(root).colorScheme);
  expect(await scheme()).toBe("light");
});

test("only the page around is heard, and only what it may say", async ({ page, blog, baseURL }) => {
  await openFramed({ page, blog, baseURL }, { more: `<iframe name="neighbour" srcdoc="x" title="Another"></iframe>` });
  await river(page).evaluate((element) => {
    const themes: (string | null)[] = [];
    Object.assign(globalThis, { themes });
    new MutationObserver(() => themes.push(element.getAttribute("theme"))).observe(element, { attributes: true });
  });
  await page.frame("neighbour")?.evaluate(() => parent.frames[0]?.postMessage({ riverseed: { theme: "dark" } }, "*"));
  for (const message of [
    null,
    "dark",
    { theme: "dark" },
    { riverseed: { theme: "<b>" } },
    { riverseed: { recipe: "seed=x" } },
  ])
    await post(page, message);
  // Messages arrive in order: with this one all others have been passed over.
  await post(page, { riverseed: { theme: "light" } });
  await expect(river(page)).toHaveAttribute("theme", "light");
  expect(await river(page).evaluate(() => (globalThis as unknown as { themes: string[] }).themes)).toEqual(["light"]);
  await expect(river(page)).toHaveAttribute("recipe", LINK);
});

test("the host script listens to no one but frames of the site", async ({ page, blog, baseURL }) => {
  await openFramed(
    { page, blog, baseURL },
    {
      more: `<iframe name="stranger" srcdoc="x" title="A stranger" height="50"></iframe>
      <iframe name="other" src="SITE/digest.html" title="Another page of the site" height="50"></iframe>
      <iframe name="turned" src="SITE/embed.html?${LINK}" title="A river at first" height="50"></iframe>
      <script src="SITE/embed-host.js"></script>`,
    },
  );
  await expect(page.locator("iframe").first()).toHaveCSS("height", "300px");
  blog.answer("/evil.html", { body: "<title>Evil</title>" });
  await page.frame("turned")?.goto(`${blog.origin}/evil.html`);
  await page.evaluate(() => document.querySelector<HTMLElement>("[name=turned]")?.style.removeProperty("height"));
  const evil = { riverseed: { height: 9999 } };
  for (const name of ["stranger", "other", "turned"])
    await page.frame(name)?.evaluate((evil) => parent.postMessage(evil, "*"), evil);
  await page.evaluate((evil) => postMessage(evil, "*"), evil);
  const first = page.frames().find((frame) => frame.url().includes("/embed.html"));
  for (const height of [-1, 0, 1e9, "300px", null, { valueOf: 1 }])
    await first?.evaluate((height) => parent.postMessage({ riverseed: { height } }, "*"), height);
  await first?.evaluate(() => parent.postMessage({ riverseed: { height: 123 } }, "*"));
  await expect(page.locator("iframe").first()).toHaveCSS("height", "123px");
  for (const name of ["stranger", "other", "turned"])
    await expect(page.locator(`iframe[name=${name}]`)).toHaveCSS("height", "50px");
});

test("nothing is shown but the river, and nothing scrolls", async ({ page }) => {
  await page.setViewportSize({ width: 300, height: 150 });
  await page.goto(`./embed.html?${LINK}`);
  await expect(page.locator(":root")).toHaveAttribute("data-state", "ready");
  expect(await page.locator("body > :visible").count()).toBe(1);
  expect(await violationsInFrame(page)).toEqual([]);
  await page.mouse.wheel(0, 200);
  expect(await page.evaluate(() => [scrollX, scrollY])).toEqual([0, 0]);
  expect(await page.evaluate(() => getComputedStyle(document.documentElement).overflow)).toBe("hidden");
});

test("in a frame of another shape the river is seen whole, in the middle", async ({ page }) => {
  await page.setViewportSize({ width: 480, height: 320 });
  await page.goto(`./embed.html?${LINK}&aspect=2`);
  const canvas = page.locator("river-seed canvas");
  await expect(canvas).toHaveCount(1);
  expect(await canvas.boundingBox()).toEqual({ x: 0, y: 40, width: 480, height: 240 });
  await page.setViewportSize({ width: 480, height: 199 });
  await expect.poll(() => canvas.boundingBox()).toEqual({ x: 40, y: -0.5, width: 400, height: 200 });
});

test("the element's attributes are taken from the query, and nothing else is", async ({ page }) => {
  await page.goto(`./embed.html?${LINK}&theme=dark&controls&onclick=alert(1)&alt=x`);
  const element = page.locator("river-seed");
  await expect(element).toHaveAttribute("theme", "dark");
  await expect(element).toHaveAttribute("controls", "");
  expect(await element.evaluate(({ attributes }) => [...attributes].map(({ name }) => name).sort())).toEqual([
    "controls",
    "recipe",
    "theme",
  ]);
});

test("what had to be corrected is shown over the river, as text, and can be dismissed", async ({ page }) => {
  await page.goto(`./embed.html?seed=kowhai&attractors=300&curl=99&%3Cimg%20src=x%20onerror=alert(1)%3E=1`);
  const note = page.getByRole("status").filter({ hasText: "curl" });
  await expect(note).toContainText("curl: 99 is not between 0 and 2: 2 is used");
  await expect(note).toContainText("<img src");
  expect(await violationsInFrame(page)).toEqual([]);
  await expect(page.locator("img")).toHaveCount(0);
  await note.getByRole("button", { name: "Dismiss" }).click();
  await expect(note).toBeHidden();
});

test("a failure is said in the river's place, by its name, and the page around gives it room @core", async ({
  page,
  blog,
  baseURL,
}) => {
  const heard = await heights(page);
  await page.route("**/*.wasm", (route) => route.fulfill({ status: 404, body: "not here" }));
  await openElsewhere(
    { page, blog, baseURL },
    `<iframe src="SITE/embed.html?${LINK}" title="Rivers" width="300" height="60"></iframe>`,
  );
  const note = page.frameLocator("iframe").getByRole("alert");
  await expect(note).toContainText("file-missing");
  await expect(note).toContainText("Load the page again");
  const height = await note.evaluate((element) => element.getBoundingClientRect().height);
  await expect.poll(async () => (await heard()).at(-1)).toBeGreaterThanOrEqual(Math.floor(height));
});

/** An iframe that has no origin: its files are fetched as by a page of another site. */
const SANDBOXED = `<iframe src="SITE/embed.html?${LINK}" title="Rivers" width="480" height="300" sandbox="allow-scripts"></iframe>`;

test("a sandboxed iframe without an origin says what it lacks", async ({ page, blog, baseURL }) => {
  await openElsewhere({ page, blog, baseURL }, SANDBOXED);
  const frame = page.frameLocator("iframe");
  await expect(frame.getByText("The rivers did not load.")).toBeVisible();
  await expect(frame.getByText("allow-scripts allow-same-origin")).toBeVisible();
  await expect(frame.locator("river-seed")).toHaveCount(0);
});

test("where the site sends CORS for its assets, a sandboxed iframe without an origin draws the same river", async ({
  page,
  blog,
  baseURL,
}) => {
  await page.route("**/assets/**", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), "access-control-allow-origin": "*" } });
  });
  await openElsewhere({ page, blog, baseURL }, SANDBOXED.replace("<iframe", '<iframe style="border:0"'));
  const frame = page.frameLocator("iframe");
  await expect(frame.locator(":root")).toHaveAttribute("data-state", "ready");
  await expect.poll(() => showsRiver(page, page.locator("iframe"), LINK)).toBe(true);
  await expect(frame.getByText("The rivers did not load.")).toHaveCount(0);
});

test("a slow script does not make an iframe say that something is missing", async ({ page }) => {
  await page.route("**/assets/embed-*.js", () => {});
  await page.goto(`./embed.html?${LINK}`, { waitUntil: "commit" });
  await expect(page.locator("#missing")).toBeAttached();
  await expect(page.locator("#missing")).toBeHidden();
});

test.describe("without JavaScript", () => {
  test.use({ javaScriptEnabled: false });
  test("an iframe asks for it, and for nothing else", async ({ page }) => {
    await page.goto(`./embed.html?${LINK}`);
    await expect(page.locator("noscript p")).toBeVisible();
    await expect(page.locator("#missing")).toBeHidden();
  });
});
