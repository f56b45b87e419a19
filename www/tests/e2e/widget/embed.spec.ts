import type { Page } from "@playwright/test";
import { complaints } from "../riverpage.ts";
import { core } from "../tiers.ts";
import { expect, test } from "./hosts.ts";
import { canonical, expectPicture, heard, listen, post, STRICT } from "./post.ts";

const ATTRIBUTES = 'seed="rimu" attractors="400" still';
const LINK = canonical("seed=rimu&attractors=400");

/** Where the renderer was. */
function workers(page: Page): string[] {
  return page.workers().map((worker) => worker.url());
}

test("a plain page shows the core's picture, from a worker @core", async ({ page, blog }) => {
  const said = complaints(page);
  const events = await listen(page);
  blog.answer("/", { body: post(`<river-seed ${ATTRIBUTES}></river-seed>`) });
  await page.goto(blog.origin);
  expect((await heard(events, "complete")).detail).toMatchObject({ link: LINK, summary: { finished: true } });
  await expectPicture(page, LINK);
  expect(workers(page)).toEqual([`${blog.origin}/widget/worker.js`]);
  expect(said).toEqual([]);
});

test("a script from another origin works as well, in a worker too", async ({ page, blog, cdn }) => {
  const said = complaints(page);
  const events = await listen(page);
  blog.answer("/", { body: post(`<river-seed ${ATTRIBUTES}></river-seed>`, `${cdn.origin}/river-seed.js`) });
  await page.goto(blog.origin);
  await heard(events, "complete");
  await expectPicture(page, LINK);
  expect(workers(page)).toEqual([expect.stringMatching(/^blob:/)]);
  expect(cdn.asked.toSorted()).toEqual(["/river-seed.js", "/riverseed_label_bg.wasm", "/worker.js"]);
  expect(said).toEqual([]);
});

test("a strict policy is kept: nothing inline, nothing evaluated @core", async ({ page, blog }) => {
  const said = complaints(page);
  const events = await listen(page);
  blog.headers = { "content-security-policy": STRICT };
  blog.answer("/", { body: post(`<river-seed ${ATTRIBUTES} controls></river-seed>`).replace('href="data:,"', "") });
  await page.goto(blog.origin);
  await heard(events, "complete");
  await expectPicture(page, LINK);
  await expect(page.getByRole("button")).toBeVisible();
  const { width, height } = (await page.locator("river-seed").boundingBox()) ?? { width: 0, height: 1 };
  expect(width / height).toBeCloseTo(1.6, 1);
  expect(said.filter((text) => !text.includes("favicon"))).toEqual([]);
});

const REFUSALS: [why: string, policy: string][] = [
  ["the page's policy", STRICT.replace("worker-src 'self'", "worker-src 'none'")],
  ["the policy of a page with a script from elsewhere", "worker-src 'self'"],
  ["a policy of trusted types", `${STRICT}; require-trusted-types-for 'script'`],
];

for (const [why, policy] of REFUSALS) {
  test(`where ${why} refuses a worker, the page itself draws the same picture`, async ({ page, blog, cdn }) => {
    const events = await listen(page);
    const isElsewhere = !policy.includes("script-src");
    blog.headers = { "content-security-policy": policy };
    const script = isElsewhere ? `${cdn.origin}/river-seed.js` : undefined;
    blog.answer("/", { body: post(`<river-seed ${ATTRIBUTES}></river-seed>`, script) });
    await page.goto(blog.origin);
    await heard(events, "complete");
    await expectPicture(page, LINK);
    expect(workers(page)).toEqual([]);
  });
}

test("a browser without canvases for workers draws the same picture", async ({ page, blog }) => {
  const events = await listen(page);
  await page.addInitScript(() => {
    Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen");
    Reflect.deleteProperty(globalThis, "OffscreenCanvas");
  });
  blog.answer("/", { body: post(`<river-seed ${ATTRIBUTES}></river-seed>`) });
  await page.goto(blog.origin);
  await heard(events, "complete");
  await expectPicture(page, LINK);
  expect(blog.asked).not.toContain("/widget/worker.js");
});

test("included twice, under two addresses, it is there once", async ({ page, blog, cdn }) => {
  const said = complaints(page);
  const events = await listen(page);
  const twice = `<script type="module" src="/widget/river-seed.js"></script>
    <script type="module" src="/widget/define.js"></script><script type="module" src="${cdn.origin}/river-seed.js"></script>`;
  blog.answer("/", { body: post(`${twice}<river-seed ${ATTRIBUTES}></river-seed>`) });
  await page.goto(blog.origin);
  await heard(events, "complete");
  await expectPicture(page, LINK);
  expect([...blog.asked, ...cdn.asked].filter((path) => path.endsWith("/riverseed_label_bg.wasm"))).toHaveLength(1);
  expect(said).toEqual([]);
});

for (const place of ["a worker", "the page"]) {
  test(`twenty on a page share one engine in ${place}${core(place === "a worker")}`, async ({ page, blog }) => {
    const events = await listen(page);
    if (place === "the page") blog.headers = { "content-security-policy": "worker-src 'none'" };
    const seeds = Array.from({ length: 20 }, (_, i) => `seed${i}`);
    const widget = (seed: string): string =>
      `<river-seed id="${seed}" seed="${seed}" attractors="200" loading="eager" style="width: 150px"></river-seed>`;
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.setViewportSize({ width: 1280, height: 3000 });
    blog.answer("/", { body: post(seeds.map(widget).join("")) });
    await page.goto(blog.origin);
    await heard(events, "complete", 20);
    expect(new Set((await events()).filter(({ type }) => type === "complete").map(({ id }) => id))).toEqual(
      new Set(seeds),
    );
    for (const seed of ["seed0", "seed19"])
      await expectPicture(page, canonical(`seed=${seed}&attractors=200`), `#${seed}`);
    expect(page.workers()).toHaveLength(place === "a worker" ? 1 : 0);
  });
}
