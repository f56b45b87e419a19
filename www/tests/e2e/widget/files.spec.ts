import { createHash } from "node:crypto";
import type { Page } from "@playwright/test";
import { pictureOf } from "../../core.ts";
import { core } from "../tiers.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, heard, listen, post } from "./post.ts";

type RiverSeed = HTMLElementTagNameMap["river-seed"];

/** What a PNG shows. */
async function png(page: Page, longSide: number): Promise<{ width: number; height: number; sha256: string }> {
  const shown = await page.locator("river-seed").evaluate(async (river: RiverSeed, longSide) => {
    const blob = await river.toBlob({ longSide });
    const bitmap = await createImageBitmap(blob);
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    context?.drawImage(bitmap, 0, 0);
    return { type: blob.type, width, height, bytes: [...(context?.getImageData(0, 0, width, height).data ?? [])] };
  }, longSide);
  expect(shown.type).toBe("image/png");
  const { width, height } = shown;
  return { width, height, sha256: createHash("sha256").update(Buffer.from(shown.bytes)).digest("hex") };
}

async function open(page: Page, blog: Host, place: string): Promise<void> {
  if (place === "the page") blog.headers = { "content-security-policy": "worker-src 'none'" };
  const events = await listen(page);
  blog.answer("/", { body: post('<river-seed seed="rimu" attractors="300" meander-rounds="60"></river-seed>') });
  await page.goto(blog.origin);
  await heard(events, "ready");
}

for (const place of ["a worker", "the page"]) {
  const link = canonical("seed=rimu&attractors=300&meander-rounds=60");

  test(`a PNG is of the finished river, at a size of choice: ${place}${core(place === "a worker")}`, async ({
    page,
    blog,
  }) => {
    await open(page, blog, place);
    expect(await png(page, 240)).toEqual({ width: 240, height: 150, sha256: pictureOf(link, 240, 150).sha256 });
    const [width, shown] = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
      const { width } = await createImageBitmap(await river.toBlob());
      return [width, river.shadowRoot?.querySelector("canvas")?.width];
    });
    expect(width).toBe(shown);
  });

  test(`an SVG is of the finished river, by the whole engine, which is fetched for it: ${place}${core(place === "a worker")}`, async ({
    page,
    blog,
  }) => {
    await open(page, blog, place);
    expect(blog.asked).not.toContain("/widget/riverseed_engine_bg.wasm");
    const svg = await page.locator("river-seed").evaluate((river: RiverSeed) => river.toSVG());
    expect(svg).toMatch(/^<svg|^<\?xml/);
    expect(svg).toContain('id="river-');
    expect(svg).toContain(link.replaceAll("&", "&amp;"));
    expect(blog.asked).toContain("/widget/riverseed_engine_bg.wasm");
  });
}

test("an engine that does not arrive is an error with a name, and the picture stays", async ({ page, blog }) => {
  blog.answer("/widget/riverseed_engine_bg.wasm", { status: 404 });
  await open(page, blog, "a worker");
  const code = await page
    .locator("river-seed")
    .evaluate((river: RiverSeed) => river.toSVG().catch((error: { code: string }) => error.code));
  expect(code).toBe("file-missing");
  await expect(page.locator("river-seed canvas")).toBeVisible();
});

test("a size that no picture can have is an error with a name", async ({ page, blog }) => {
  await open(page, blog, "a worker");
  for (const [longSide, code] of [
    [100_000, "too-large"],
    [Number.NaN, "bad-params"],
  ] as const) {
    const said = await page
      .locator("river-seed")
      .evaluate(
        (river: RiverSeed, longSide) => river.toBlob({ longSide }).catch((error: { code: string }) => error.code),
        longSide,
      );
    expect(said).toBe(code);
  }
});

test("a picture of one that is not laid out needs a size, and says so", async ({ page, blog }) => {
  await open(page, blog, "a worker");
  const said = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    river.hidden = true;
    const refusal = await river.toBlob().catch((error: Error) => `${error.name}: ${error.message}`);
    return [refusal, (await createImageBitmap(await river.toBlob({ longSide: 160 }))).width];
  });
  expect(said).toEqual(["InvalidStateError: this river-seed is not laid out: say how long its longSide is", 160]);
});

test("a PNG has the woods that a word's country has, also of one that was never seen", async ({ page, blog }) => {
  const link = "seed=5&attractors=1500&style=parchment&labels=none";
  await listen(page);
  blog.answer("/", { body: post(`<div style="height: 4000px"></div><river-seed recipe="${link}"></river-seed>`) });
  await page.goto(blog.origin);
  const { sha256 } = await png(page, 240);
  expect(sha256).toBe(pictureOf(link, 240, 150).sha256);
  expect(sha256).not.toBe(pictureOf(`${link}&woods=0`, 240, 150).sha256);
});
