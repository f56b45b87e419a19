import type { Page } from "@playwright/test";
import { pictureOf } from "../../core.ts";
import { complaints } from "../riverpage.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, frames, type Heard, heard, listen, post } from "./post.ts";

type RiverSeed = HTMLElementTagNameMap["river-seed"];

test.beforeEach(({ page }) => page.emulateMedia({ reducedMotion: "reduce" }));

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

async function change(page: Page, work: (river: RiverSeed) => void): Promise<void> {
  await page.locator("river-seed").evaluate(work);
}

test("attributes are the table's keys, two of them with a prefix @core", async ({ page, blog }) => {
  const events = await open(
    page,
    blog,
    '<river-seed seed="rimu" attractors="300" meander-rounds="5" river-style="atlas" river-width="20" land="island"></river-seed>',
  );
  const link = canonical("seed=rimu&attractors=300&meander-rounds=5&style=atlas&width=20&land=island");
  expect((await heard(events, "complete")).detail["link"]).toBe(link);
  await expectPicture(page, link);
});

test("attributes win over what the recipe says", async ({ page, blog }) => {
  const recipe = "?preset=curl&seed=kauri&attractors=300&curl=0.2";
  const events = await open(
    page,
    blog,
    `<river-seed recipe="${recipe.replaceAll("&", "&amp;")}" seed="a&amp;b"></river-seed>`,
  );
  const link = canonical("preset=curl&seed=a%26b&attractors=300&curl=0.2");
  expect((await heard(events, "ready")).detail).toEqual({ link, notices: [] });
});

test("an address as the recipe or the seed is its map, and damage is told", async ({ page, blog }) => {
  const link = "seed=rimu&attractors=300&labels=none&style=ink";
  const address = `https://rivers.example/?${link.replaceAll("&", "&amp;")}`;
  const events = await open(page, blog, `<river-seed recipe="${address}"></river-seed>`);
  expect((await heard(events, "ready")).detail).toEqual({ link: canonical(link), notices: [] });
  await expectPicture(page, canonical(link));
  const told = await open(
    page,
    blog,
    `<river-seed curl="1" seed="(${address.replaceAll("&amp;", "&amp;amp;")})"></river-seed>`,
  );
  const { detail } = await heard(told, "ready");
  expect(detail["link"]).toBe(canonical(`${link}&curl=1`));
  expect(detail["notices"]).toEqual([{ key: "link", message: expect.stringContaining("has been mended") }]);
});

test("properties set before the class is known count, and are attributes afterwards", async ({ page, blog }) => {
  const events = await listen(page);
  blog.answer("/", { body: post("<river-seed></river-seed>").replace(/<script type="module".*?<\/script>/, "") });
  await page.goto(blog.origin);
  await change(page, (river) => {
    Object.assign(river, { seed: "totara", attractors: 300, riverStyle: "atlas", meanderRounds: 3, controls: true });
    river.i18n = { replay: "Once more" };
  });
  await page.addScriptTag({ type: "module", url: "/widget/river-seed.js" });
  const link = canonical("seed=totara&attractors=300&style=atlas&meander-rounds=3");
  expect((await heard(events, "complete")).detail["link"]).toBe(link);
  await expect(page.getByRole("button", { name: "Once more" })).toBeVisible();
  const reflected = { seed: "totara", attractors: "300", "river-style": "atlas", "meander-rounds": "3", controls: "" };
  for (const [name, value] of Object.entries(reflected)) {
    await expect(page.locator("river-seed")).toHaveAttribute(name, value);
  }
});

test("properties mirror attributes", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed attractors="300"></river-seed>');
  await heard(events, "complete");
  const seen = await page.locator("river-seed").evaluate((river: RiverSeed) => {
    const before = [river.seed, river.attractors, river.controls, river.still, river.alt];
    Object.assign(river, { seed: "miro", attractors: null, controls: false, alt: "", still: true });
    const names = river.getAttributeNames().map((name) => [name, river.getAttribute(name)]);
    river.sea = "auto";
    return { before, names, left: [river.sea, river.getAttribute("sea")] };
  });
  expect(seen.left).toEqual(["auto", "auto"]);
  expect(seen.before).toEqual([null, 300, false, false, null]);
  expect(Object.fromEntries(seen.names)).toEqual({ seed: "miro", alt: "", still: "" });
});

test("what changes in one turn changes once, and what is the same changes nothing", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed seed="a" attractors="300"></river-seed>');
  await heard(events, "complete");
  await change(page, (river) => {
    river.seed = "b";
    river.setAttribute("curl", "0.4");
    river.seed = "c";
  });
  const link = canonical("seed=c&attractors=300&curl=0.4");
  expect((await heard(events, "complete", 2)).detail["link"]).toBe(link);
  await change(page, (river) => {
    river.seed = "d";
    river.seed = "c";
  });
  await change(page, (river) => river.setAttribute("attractors", "301"));
  await heard(events, "complete", 3);
  const links = (await events()).filter(({ type }) => type === "complete").map(({ detail }) => detail["link"]);
  expect(links).toEqual([canonical("seed=a&attractors=300"), link, canonical("seed=c&attractors=301&curl=0.4")]);
});

test("ready comes once, before complete; progress in between @core", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  const events = await open(page, blog, '<river-seed attractors="300"></river-seed>');
  await heard(events, "complete");
  const types = (await events()).map(({ type }) => type);
  expect(types.filter((type) => type !== "progress")).toEqual(["ready", "complete"]);
  const progress = (await events()).filter(({ type }) => type === "progress");
  expect(progress.map(({ detail }) => detail["phase"])).toContain("growing");
});

const JUNK = `<river-seed seed="${"x".repeat(500)}" attractors="many" aspect="-3" reach="1e99" river-style="<b>" outline="!!!"
  recipe="%%%&=&seed&frogs=7&amp;curl=NaN" theme="pink" loading="never" still="sideways" lang="no language"></river-seed>`;

test("junk is corrected, and reported @core", async ({ page, blog }) => {
  const said = complaints(page);
  const events = await open(page, blog, JUNK);
  const { detail } = await heard(events, "ready");
  const keys = (detail["notices"] as { key: string }[]).map(({ key }) => key);
  for (const key of ["seed", "attractors", "aspect", "reach", "style", "frogs", "curl"]) expect(keys).toContain(key);
  await heard(events, "complete");
  expect(said).toEqual([expect.stringMatching(/^river-seed: .*many/s)]);
});

test("what is corrected in attributes that change is told, once for each change @core", async ({ page, blog }) => {
  const said = complaints(page);
  const events = await open(page, blog, '<river-seed attractors="300" curl="0.4" still></river-seed>');
  await heard(events, "complete");
  const corrected = async () => (await events()).filter(({ type }) => type === "corrected").map(({ detail }) => detail);
  expect(await corrected()).toEqual([]);
  const river = page.locator("river-seed");
  await river.evaluate((river) => river.setAttribute("curl", "much"));
  await heard(events, "corrected");
  await river.evaluate((river) => river.setAttribute("curl", "0.3"));
  await expectPicture(page, canonical("attractors=300&curl=0.3"));
  await river.evaluate((river) => river.setAttribute("aspect", "-3"));
  await heard(events, "corrected", 2);
  expect(await corrected()).toMatchObject([{ notices: [{ key: "curl" }] }, { notices: [{ key: "aspect" }] }]);
  expect(said).toEqual([expect.stringMatching(/^river-seed: .*much/s), expect.stringMatching(/^river-seed: .*-3/s)]);
});

test("what is told of a river is told of that river, though another waits for its turn", async ({ page, blog }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const events = await open(page, blog, '<river-seed seed="one" attractors="9000"></river-seed>');
  for (const seed of ["two", "three", "four", "five", "six"]) {
    await page.locator("river-seed").evaluate((river, seed) => river.setAttribute("seed", seed), seed);
    await frames(page, 2);
  }
  await expectPicture(page, canonical("seed=six&attractors=9000"));
  for (const { type, detail } of await events()) {
    if (type !== "complete") continue;
    const { link, summary } = detail as { link: string; summary: object };
    expect(summary).toEqual(pictureOf(link, 16, 16).summary);
  }
});

test("a widget grows no more than a page bears, and says so", async ({ page, blog }) => {
  const events = await open(page, blog, '<river-seed country="usual" attractors="1000000" still></river-seed>');
  const { detail } = await heard(events, "ready");
  expect(detail).toMatchObject({ link: canonical("country=usual&attractors=24000"), notices: [{ key: "attractors" }] });
});

for (const [what, scheme, attributes, isDark] of [
  ["a dark scheme", "dark", "", true],
  ["a light scheme", "light", "", false],
  ["the dark theme on a light page", "light", 'theme="dark"', true],
  ["the light theme on a dark page", "dark", 'theme="light"', false],
  ["a page that says it is light", "dark", 'style="color-scheme: light"', false],
  ["a style of the author's choice", "dark", 'river-style="atlas"', false],
  ["a style in the recipe", "dark", 'recipe="style=atlas"', false],
] as const) {
  test(`light rivers on dark paper with ${what}: ${isDark}`, async ({ page, blog }) => {
    await page.emulateMedia({ colorScheme: scheme });
    const events = await open(page, blog, `<river-seed attractors="300" ${attributes}></river-seed>`);
    const style = attributes.includes("atlas") ? "&style=atlas" : isDark ? "&style=night" : "";
    expect((await heard(events, "complete")).detail["link"]).toBe(canonical(`attractors=300${style}`));
    await expectPicture(page, canonical(`attractors=300${style}`));
  });
}
