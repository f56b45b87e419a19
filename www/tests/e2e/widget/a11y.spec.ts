import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "@playwright/test";
import type { AxeResults } from "axe-core";
import { core } from "../tiers.ts";
import { expect, type Host, test } from "./hosts.ts";
import { type Heard, heard, listen, post } from "./post.ts";

type RiverSeed = HTMLElementTagNameMap["river-seed"];

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

async function violations(page: Page): Promise<string[]> {
  await page.evaluate(axe);
  const results = await page.evaluate(() => {
    const { axe } = globalThis as unknown as { axe: { run(): Promise<AxeResults> } };
    return axe.run();
  });
  return results.violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join("; ")}`);
}

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

const SMALL = 'seed="rimu" attractors="300"';
/** So many rounds that no test sees the end of them. */
const LONG = 'seed="rimu" meander-rounds="400"';

const FORMS = [
  "",
  "controls",
  'alt="Rivers of the north"',
  'alt=""',
  'aria-label="Rivers"',
  "still",
  'theme="dark" controls',
  'maker="https://maps.example/"',
  'maker="https://maps.example/" theme="dark"',
];

for (const attributes of FORMS) {
  test(`axe finds nothing: <river-seed ${attributes}>${core(attributes === "controls")}`, async ({ page, blog }) => {
    const events = await open(page, blog, `<river-seed ${SMALL} ${attributes}><p>A river.</p></river-seed>`);
    await heard(events, "ready");
    expect(await violations(page)).toEqual([]);
    await heard(events, "complete");
    expect(await violations(page)).toEqual([]);
  });
}

test("axe finds nothing in a failure, and in forced colours", async ({ page, blog }) => {
  await page.emulateMedia({ forcedColors: "active" });
  const events = await open(page, blog, `<river-seed ${SMALL} controls></river-seed>`);
  await heard(events, "complete");
  expect(await violations(page)).toEqual([]);
  blog.answer("/widget/riverseed_label_bg.wasm", { status: 404 });
  await page.reload();
  await expect(page.getByText("cannot be shown")).toBeVisible();
  expect(await violations(page)).toEqual([]);
});

test("the picture is an image with a name that is true of it @core", async ({ page, blog }) => {
  // So that it is not finished before it was looked at.
  await page.addInitScript(() => {
    document.addEventListener("ready", ({ target }) => (target as RiverSeed).pause(), true);
  });
  const events = await open(page, blog, `<river-seed ${SMALL} lang="de"></river-seed>`);
  await heard(events, "ready");
  await expect(
    page.getByRole("img", { name: "River network grown from the seed “rimu”: still growing." }),
  ).toBeVisible();
  await page.locator("river-seed").evaluate((river: RiverSeed) => river.play());
  const { detail } = await heard(events, "complete");
  const { mouths, sources } = detail["summary"] as { mouths: number; sources: number };
  const name = `River network grown from the seed “rimu”: ${mouths} rivers, ${sources} sources`;
  await expect(page.getByRole("img", { name })).toBeVisible();
  await expect(page.getByRole("status")).toHaveText(/^Finished: /);
});

test("the author's words come first, and may be none", async ({ page, blog }) => {
  const widgets = ['alt="The north"', 'alt="The north" aria-label="The south"', 'alt=""'];
  const events = await open(
    page,
    blog,
    widgets.map((alt) => `<river-seed ${SMALL} still ${alt}></river-seed>`).join(""),
  );
  await page.setViewportSize({ width: 600, height: 2400 });
  await heard(events, "complete", 3);
  await expect(page.getByRole("img", { name: "The north" })).toHaveCount(1);
  await expect(page.getByRole("img", { name: "The south" })).toHaveCount(1);
  await expect(page.getByRole("img")).toHaveCount(2);
  await expect(page.getByRole("status").nth(2)).toHaveText("");
  // What the author wrote on the element is as it was.
  expect(await page.locator("river-seed").nth(1).getAttribute("aria-label")).toBe("The south");
  expect(await page.locator("river-seed").nth(0).getAttribute("role")).toBeNull();
});

test("growth that begins by itself can be paused, by keys too, and goes on @core", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed ${LONG}></river-seed>`);
  await heard(events, "ready");
  const pause = page.getByRole("button", { name: "Pause the rivers" });
  await expect(pause).toBeVisible();
  await page.keyboard.press("Tab");
  await expect(pause).toBeFocused();
  const { width, height } = (await pause.boundingBox()) ?? { width: 0, height: 0 };
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(24);
  expect(await pause.evaluate((button) => getComputedStyle(button).outlineStyle)).toBe("solid");
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Let the rivers grow" })).toBeFocused();
  const count = (await events()).length;
  await page.keyboard.press("Enter");
  await expect(pause).toBeFocused();
  await expect.poll(async () => (await events()).length).toBeGreaterThan(count);
});

test("finished, the button waits for a pointer or the focus; with controls it stays", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed ${SMALL}></river-seed>`);
  await heard(events, "complete");
  const again = page.getByRole("button", { name: "Grow the rivers again" });
  await expect(again).toHaveCSS("opacity", "0");
  await page.locator("river-seed").hover();
  await expect(again).toHaveCSS("opacity", "1");
  await page.mouse.move(0, 0);
  await expect(again).toHaveCSS("opacity", "0");
  await page.keyboard.press("Tab");
  await expect(again).toHaveCSS("opacity", "1");
  await page.locator("river-seed").evaluate((river) => river.setAttribute("controls", ""));
  await page.locator("body").click({ position: { x: 1, y: 1 } });
  await expect(again).toHaveCSS("opacity", "1");
});

test("a still river has no button, unless it is asked for", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed ${SMALL} still></river-seed>`);
  await heard(events, "complete");
  await expect(page.getByRole("button")).toHaveCount(0);
  await page.locator("river-seed").evaluate((river) => river.setAttribute("controls", ""));
  await expect(page.getByRole("button", { name: "Grow the rivers again" })).toBeVisible();
});

test("every string can be replaced", async ({ page, blog }) => {
  const events = await open(page, blog, `<river-seed ${SMALL} controls still lang="de"></river-seed>`);
  await heard(events, "complete");
  await page.locator("river-seed").evaluate((river: HTMLElementTagNameMap["river-seed"]) => {
    river.i18n = {
      replay: "Noch einmal",
      alternative: ({ seed, summary, count }) => `Flüsse aus „${seed}“: ${count(summary.nodes * 1000)} Knoten`,
    };
  });
  await expect(page.getByRole("button", { name: "Noch einmal" })).toBeVisible();
  await expect(page.getByRole("img", { name: /^Flüsse aus „rimu“: \d+\.000 Knoten$/ })).toBeVisible();
});
