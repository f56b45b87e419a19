import type { Page } from "@playwright/test";
import { elementSnippet } from "../../../src/apps/page/share/snippets.ts";
import { engine } from "../../core.ts";
import { core } from "../tiers.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, type Heard, heard, listen, pixels, post } from "./post.ts";

const LINK = "seed=kauri&attractors=1500&meander-rounds=5";
const LABEL = "/widget/riverseed_label_bg.wasm";
const MAKE = "/widget/riverseed_bg.wasm";

/** The letters that the Share dialog gives for a link. */
function lettersFor(link: string): string {
  const river = new engine.River(link);
  while (river.advance(1000));
  const letters = river.lettersFor(link);
  river.free();
  if (!letters) throw new Error("there are no letters");
  return letters;
}

function snippet(link: string, letters: string, aspect = "1.6"): string {
  return elementSnippet({ link, letters, seed: "kauri", aspect, page: "https://maps.example/" }, "data:,").replace(
    /<script.*<.script>/,
    "",
  );
}

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  return events;
}

test("an embed that carries its letters has its names, and no engine that knows any is fetched @core", async ({
  page,
  blog,
}) => {
  const letters = lettersFor(LINK);
  const events = await open(page, blog, snippet(LINK, letters));
  await heard(events, "complete");
  await expectPicture(page, canonical(LINK));
  expect(blog.asked).toContain(MAKE);
  expect(blog.asked.filter((path) => path.endsWith(".wasm"))).toEqual([MAKE]);
  const carried = await pixels(page);
  // The same with the letters left out, and the map without its names.
  await open(page, blog, snippet(LINK, ""));
  await expectPicture(page, canonical(LINK));
  expect(blog.asked).toContain(LABEL);
  expect(await pixels(page)).toEqual(carried);
  await open(page, blog, snippet(`${LINK}&labels=none`, ""));
  await expectPicture(page, canonical(`${LINK}&labels=none`));
  expect(await pixels(page)).not.toEqual(carried);
  expect((await events()).filter(({ type }) => type === "error")).toEqual([]);
});

for (const [what, other] of [
  ["another seed", 'seed="rimu"'],
  ["another language", 'language="3"'],
] as const) {
  test(`letters are not shown on ${what}, which has its own names${core(what === "another seed")}`, async ({
    page,
    blog,
  }) => {
    const [name = "", value = ""] = other.replaceAll('"', "").split("=");
    const link = new URLSearchParams(LINK);
    link.set(name, value);
    const events = await open(page, blog, snippet(`${link}`, lettersFor(LINK)));
    await heard(events, "complete");
    await expectPicture(page, canonical(`${link}`));
    expect(blog.asked).toContain(LABEL);
    expect((await events()).filter(({ type }) => type === "complete")).toHaveLength(1);
  });
}

test("a map in a box of another shape has its names placed for that", async ({ page, blog }) => {
  const body = snippet(LINK, lettersFor(LINK), "4");
  const events = await open(page, blog, body.replace('style="', 'style="width:800px;height:200px;'));
  await heard(events, "complete");
  await expectPicture(page, canonical(LINK));
  expect(blog.asked).toContain(LABEL);
  expect((await events()).filter(({ type }) => type === "complete")).toHaveLength(1);
});

test("letters that are none are no failure, and a map that changes fetches what it needs", async ({ page, blog }) => {
  const events = await open(page, blog, snippet(LINK, "<damaged>"));
  await heard(events, "complete");
  await expectPicture(page, canonical(LINK));
  await open(page, blog, snippet(LINK, lettersFor(LINK)));
  await expectPicture(page, canonical(LINK));
  const asked = blog.asked.length;
  await page.locator("river-seed").evaluate((river) => river.setAttribute("seed", "rimu"));
  await expectPicture(page, canonical(LINK.replace("kauri", "rimu")));
  expect(blog.asked.slice(asked)).toContain(LABEL);
  expect((await events()).filter(({ type }) => type === "error")).toEqual([]);
});

test("a map without names whose word draws a country with woods has its trees @core", async ({ page, blog }) => {
  const link = "seed=5&attractors=1500&style=parchment&labels=none";
  expect(new engine.River(link).isAnnotated).toBe(true);
  const events = await open(page, blog, `<river-seed recipe="${link}"></river-seed>`);
  await heard(events, "complete");
  await expectPicture(page, canonical(link));
  expect(blog.asked).toContain(LABEL);
  expect((await events()).filter(({ type }) => type === "complete")).toHaveLength(1);
});
