/** The map as a place: moved, zoomed, and seen in other styles. */

import { expect, type Page, test } from "@playwright/test";
import type { Framing } from "../../src/browser/canvas.ts";
import { pictureOf } from "../core.ts";
import { table } from "../table.ts";
import {
  expectAddress,
  expectPictureOfAddress,
  finished,
  framing,
  openBegun,
  openFinished,
  shown,
} from "./riverpage.ts";

const LINK = "seed=rimu&attractors=900&style=atlas";

/** Waits until the picture is painted for what it shows, and returns that. */
async function painted(page: Page, before: Framing): Promise<Framing> {
  await expect.poll(async () => `${await framing(page)}`).not.toBe(`${before}`);
  await expect.poll(() => page.locator("#canvas").evaluate((canvas: HTMLElement) => canvas.style.transform)).toBe("");
  await expectPictureOfAddress(page);
  return framing(page);
}

test("the picture fills the window, and the map lies in what of it nothing covers @core", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openFinished(page, LINK);
  expect(await page.locator("#canvas").boundingBox()).toEqual({ x: 0, y: 0, width: 1440, height: 900 });
  const map = await page.locator("#map-place").boundingBox();
  const bar = await page.locator(".bar").boundingBox();
  const styles = await page.locator("#styles").boundingBox();
  if (!map || !bar || !styles) throw new Error("no map");
  expect(map.width / map.height).toBeCloseTo(1.6, 2);
  expect(map.y + map.height).toBeLessThanOrEqual(bar.y);
  expect(map.x + map.width).toBeLessThanOrEqual(styles.x);
  await expectPictureOfAddress(page);
});

test("a wheel over the map brings what lies under it closer, sharp @core", async ({ page }) => {
  await openFinished(page, LINK);
  const first = await framing(page);
  const place = { x: 500, y: 300 };
  const width = page.viewportSize()?.width ?? 0;
  const under = ([left, top, across]: Framing): number[] =>
    [left + (place.x / width) * across, top + (place.y / width) * across].map((share) => Number(share.toFixed(6)));
  await page.mouse.move(place.x, place.y);
  await page.mouse.wheel(0, -600);
  const closer = await painted(page, first);
  expect(closer[2]).toBeLessThan(first[2] / 2);
  expect(under(closer)).toEqual(under(first));
  await page.mouse.wheel(0, 6000);
  expect(await painted(page, closer)).toEqual(first);
});

test("the map is dragged, and keys move and zoom it @core", async ({ page }) => {
  await openFinished(page, LINK);
  let last = await framing(page);
  await page.locator("#frame").focus();
  for (const [key, expected] of [
    ["+", (now: Framing, before: Framing) => now[2] < before[2]],
    ["ArrowRight", (now: Framing, before: Framing) => now[0] > before[0]],
    ["ArrowUp", (now: Framing, before: Framing) => now[1] < before[1]],
    ["-", (now: Framing, before: Framing) => now[2] > before[2]],
  ] as const) {
    await page.keyboard.press(key);
    const now = await painted(page, last);
    expect(expected(now, last), key).toBe(true);
    last = now;
  }
  await page.keyboard.press("+");
  last = await painted(page, last);
  await page.mouse.move(500, 300);
  await page.mouse.down();
  await page.mouse.move(600, 340, { steps: 5 });
  await page.mouse.up();
  const width = page.viewportSize()?.width ?? 0;
  const dragged = await painted(page, last);
  expect(dragged[0]).toBeCloseTo(last[0] - (100 / width) * last[2], 5);
  expect(dragged[1]).toBeCloseTo(last[1] - (40 / width) * last[2], 5);
});

test("buttons zoom: in first, then out while there is a way out, and no button moves for that @core", async ({
  page,
}) => {
  await openFinished(page, LINK);
  const [closer, farther, all] = ["Zoom in", "Zoom out", "Show all of the map"].map((name) =>
    page.getByRole("button", { name }),
  );
  if (!closer || !farther || !all) throw new Error("no buttons");
  const help = page.getByRole("button", { name: "Help and keys" });
  await expect(farther).toBeHidden();
  await expect(all).toBeHidden();
  const first = await framing(page);
  const places = await Promise.all([closer.boundingBox(), help.boundingBox()]);
  for (let i = 0; i < 12 && !(await closer.isDisabled()); i++) await closer.click();
  await expect(closer).toBeDisabled();
  await expect(farther).toBeVisible();
  expect(await Promise.all([closer.boundingBox(), help.boundingBox()])).toEqual(places);
  await all.press("Enter");
  await expect(all).toBeHidden();
  await expect(farther).toBeHidden();
  await expect(closer).toBeFocused();
  await expect.poll(() => framing(page)).toEqual(first);
});

test("another word begins with all of its map, however close the last one was seen; another style does not", async ({
  page,
}) => {
  await openFinished(page, `${LINK}&labels=none`);
  const whole = await framing(page);
  const all = page.getByRole("button", { name: "Show all of the map" });
  const closer = page.getByRole("button", { name: "Zoom in" });
  for (const other of [
    () => page.getByRole("button", { name: "A new seed by chance" }).click(),
    () => page.getByRole("textbox", { name: "Seed" }).fill("another word"),
  ]) {
    for (let i = 0; i < 5; i++) await closer.click();
    await painted(page, whole);
    await page.getByRole("button", { name: "Survey" }).click();
    await expectAddress(page, "style", "survey");
    await expectPictureOfAddress(page);
    expect((await framing(page))[2]).toBeLessThan(whole[2] / 5);
    await other();
    await expect(all).toBeHidden();
    await expectPictureOfAddress(page);
    expect(await framing(page)).toEqual(whole);
  }
});

test("a part of the map has labels of its own, as the engine places them @core", async ({ page }) => {
  const link = `country=usual&${LINK}`;
  await openFinished(page, `${link}&labels=many`);
  const first = await framing(page);
  await page.mouse.move(400, 300);
  await page.mouse.wheel(0, -700);
  const closer = await painted(page, first);
  const { width, height, sha256 } = await shown(page);
  expect(sha256).not.toBe(pictureOf(`${link}&labels=none`, width, height, closer).sha256);
});

test("the strip shows this map in every style, and pressing one takes it @core", async ({ page }) => {
  await openFinished(page, LINK);
  await expect(page.getByRole("button", { name: "Atlas", exact: true })).toHaveAttribute("aria-pressed", "true");
  const pictured = page.getByRole("region", { name: "Style" }).locator("canvas").locator("visible=true");
  await expect(pictured).toHaveCount(6);
  await page.getByRole("button", { name: "More styles" }).click();
  const count = await pictured.count();
  expect(count).toBe(table.parameters.find(({ key }) => key === "style")?.choices?.length);
  // Each has its own picture, once it has one.
  const pictures = (): Promise<number> =>
    pictured.evaluateAll((all) => {
      const drawn = (all as HTMLCanvasElement[]).map((canvas) => canvas.toDataURL());
      return new Set(drawn).size;
    });
  await expect.poll(pictures).toBe(count);
  await page.getByRole("button", { name: "Survey", exact: true }).click();
  await expectAddress(page, "style", "survey");
  await expect(page.getByRole("button", { name: "Survey", exact: true })).toHaveAttribute("aria-pressed", "true");
  await expectPictureOfAddress(page);
});

test("before there is a map, the strip shows each style in sight by a picture of its own", async ({ page }) => {
  const fetched = new Map<string, boolean>();
  page.on("response", (response) => {
    const [, style] = /\/styles\/(.*)\.webp$/.exec(response.url()) ?? [];
    if (style !== undefined) fetched.set(style, response.ok());
  });
  await openBegun(page, LINK);
  const styles = table.parameters.find(({ key }) => key === "style")?.choices?.slice(0, 6) ?? [];
  const expected = new Map(styles.map(({ value }) => [value, true]));
  await expect.poll(() => new Map([...fetched].sort())).toEqual(new Map([...expected].sort()));
});

test("undo and redo follow every change, and Back is undo @core", async ({ page }) => {
  await openFinished(page, LINK);
  const undo = page.getByRole("button", { name: "Undo", exact: true });
  const redo = page.getByRole("button", { name: "Redo", exact: true });
  await expect(undo).toBeHidden();
  await page.getByRole("button", { name: "Survey", exact: true }).click();
  await expectAddress(page, "style", "survey");
  await page.getByLabel("Seed", { exact: true }).fill("como");
  await page.getByLabel("Seed", { exact: true }).press("Enter");
  await expectAddress(page, "seed", "como");
  await finished(page);
  await undo.click();
  await expectAddress(page, "seed", "rimu");
  await expectAddress(page, "style", "survey");
  await page.locator("#frame").focus();
  await page.keyboard.press("Control+z");
  await expectAddress(page, "style", "atlas");
  await expect(undo).toBeDisabled();
  await page.keyboard.press("Control+Shift+z");
  await expectAddress(page, "style", "survey");
  await redo.click();
  await expectAddress(page, "seed", "como");
  await expect(redo).toBeDisabled();
  await page.goBack();
  await expectAddress(page, "seed", "rimu");
  await expectPictureOfAddress(page);
});

test("a link that is pasted over the address can be undone, and redone", async ({ page }) => {
  await openFinished(page, LINK);
  const undo = page.getByRole("button", { name: "Undo", exact: true });
  const redo = page.getByRole("button", { name: "Redo", exact: true });
  await page.evaluate(() => {
    location.hash = "seed=como&attractors=300&style=ink&labels=none";
  });
  await expectAddress(page, "seed", "como");
  await expect(redo).toBeDisabled();
  await undo.click();
  await expectAddress(page, "seed", "rimu");
  await expect(undo).toBeDisabled();
  await redo.click();
  await expectAddress(page, "seed", "como");
  await expect(page.locator("#title")).toHaveText("como");
});

test("seeds thrown in quick succession are undone one by one", async ({ page }) => {
  await openFinished(page, LINK);
  const before = await page.evaluate(() => history.length);
  const seeds = ["rimu"];
  for (let i = 0; i < 4; i++) {
    await page.getByRole("button", { name: "A new seed by chance" }).click();
    seeds.push(await page.locator("#seed").inputValue());
  }
  await expectAddress(page, "seed", seeds.at(-1) ?? "");
  expect(await page.evaluate(() => history.length)).toBe(before + 4);
  for (const seed of seeds.slice(0, -1).reverse()) {
    await page.keyboard.press("Control+z");
    await expectAddress(page, "seed", seed);
  }
});

for (const [width, height] of [
  [1440, 900],
  [800, 1000],
  [390, 844],
] as const)
  test(`undo and redo come with the first change and move no other button: ${width} by ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page, LINK);
    const others = page.locator(".bar button:not(.history *)");
    const places = (): Promise<(readonly [number, number])[]> =>
      others.evaluateAll((all) =>
        all.map((one) => [one.getBoundingClientRect().x, one.getBoundingClientRect().y] as const),
      );
    const [undo, redo] = ["Undo", "Redo"].map((name) => page.getByRole("button", { name, exact: true }));
    if (!undo || !redo) throw new Error("no buttons");
    await expect(undo).toBeHidden();
    await expect(redo).toBeHidden();
    const before = await places();
    await page.getByRole("button", { name: "A new seed by chance" }).click();
    const second = await page.locator("#seed").inputValue();
    await expect(undo).toBeEnabled();
    await expect(redo).toBeDisabled();
    expect(await places()).toEqual(before);
    const place = await undo.boundingBox();
    await undo.click();
    await expectAddress(page, "seed", "rimu");
    await expect(undo).toBeDisabled();
    expect(await undo.boundingBox()).toEqual(place);
    await redo.click();
    await expectAddress(page, "seed", second);
  });

test("a country sets land and growth, but for what is kept @core", async ({ page }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Shape…" }).click();
  await page.getByRole("button", { name: "Keep How much sea" }).click();
  const [sea] = [await page.locator("#exact-sea").inputValue()];
  await page.getByRole("button", { name: "More countries" }).click();
  const country = page.getByRole("group", { name: "Countries" }).getByRole("button", { name: "Archipelago" });
  await country.click();
  await expectAddress(page, "country", "archipelago");
  expect(await page.locator("#exact-sea").inputValue()).toBe(sea);
  await expect(country).toHaveAttribute("aria-pressed", "true");
});

test("the panel opens beside the map, is remembered, and Escape closes it @core", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openFinished(page, LINK);
  const panel = page.getByRole("region", { name: "Recipe" });
  await expect(panel).toBeHidden();
  const open = page.getByRole("button", { name: "Shape…" });
  const wide = await page.locator("#map-place").boundingBox();
  await open.click();
  await expect(panel).toBeVisible();
  await expect(open).toHaveAttribute("aria-expanded", "true");
  await expect.poll(async () => (await page.locator("#map-place").boundingBox())?.width).toBeLessThan(wide?.width ?? 0);
  const box = await page.locator("#map-place").boundingBox();
  expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual((await panel.boundingBox())?.x ?? 0);
  await page.reload();
  await finished(page);
  await expect(panel).toBeVisible();
  await page.getByRole("slider", { name: "How much sea" }).focus();
  await page.keyboard.press("Escape");
  await expect(panel).toBeHidden();
  await expect(open).toBeFocused();
});

test("a visit without a link begins with a country that has relief and names @core", async ({ page }) => {
  await openFinished(page);
  await expectAddress(page, "seed", "Kestrel");
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=Kestrel&style=atlas&labels=some", width, height, framing).sha256);
  await expectPictureOfAddress(page);
});
