import { expect, type Page, test } from "@playwright/test";
import { complaints, openFinished, ownClock, stopClock } from "./riverpage.ts";

const LINK = "seed=puriri&attractors=300";

/** Chooses a format from the menu; the file with its name. */
async function download(page: Page, format: string): Promise<{ name: string; bytes: Buffer }> {
  await page.getByRole("button", { name: "Download" }).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("menuitem", { name: new RegExp(`^${format} `) }).click(),
  ]);
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

test("the picture is saved as a large PNG under the seed's name", async ({ page }) => {
  await openFinished(page, LINK);
  const { name, bytes } = await download(page, "PNG");
  expect(name).toBe("riverseed-puriri.png");
  expect(bytes.subarray(1, 4).toString("latin1")).toBe("PNG");
  expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([3000, 2000]);
  await expect(page.locator("#shared")).toHaveText("riverseed-puriri.png is in your downloads.");
});

for (const style of ["ink", "dark", "map", "skeleton"]) {
  test(`an SVG is a picture that a browser shows: ${style}`, async ({ page }) => {
    const said = complaints(page);
    await openFinished(page, `${LINK}&land=island&style=${style}`);
    const { name, bytes } = await download(page, "SVG");
    expect(name).toBe("riverseed-puriri.svg");
    const seen = await page.evaluate(async (source) => {
      const image = new Image();
      image.src = `data:image/svg+xml;base64,${source}`;
      await image.decode();
      const { naturalWidth: width, naturalHeight: height } = image;
      const canvas = Object.assign(document.createElement("canvas"), { width: 300, height: 200 });
      const context = canvas.getContext("2d");
      context?.drawImage(image, 0, 0, 300, 200);
      const bytes = context?.getImageData(0, 0, 300, 200).data ?? [];
      return { width, height, colours: new Set(new Uint32Array(Uint8Array.from(bytes).buffer)).size };
    }, bytes.toString("base64"));
    expect(seen.width / seen.height).toBeCloseTo(1.5, 1);
    expect(seen.width).toBeGreaterThan(100);
    expect(seen.colours).toBeGreaterThan(10);
    expect(said).toEqual([]);
  });
}

test("GeoJSON is a collection of features with geometry", async ({ page }) => {
  await openFinished(page, LINK);
  const { name, bytes } = await download(page, "GeoJSON");
  expect(name).toBe("riverseed-puriri.geojson");
  const { type, features } = JSON.parse(bytes.toString("utf8"));
  expect(type).toBe("FeatureCollection");
  expect(features.length).toBeGreaterThan(10);
  for (const feature of features) {
    expect(feature.type).toBe("Feature");
    expect(feature.geometry.coordinates.length).toBeGreaterThan(0);
  }
});

test("JSON holds the network", async ({ page }) => {
  await openFinished(page, LINK);
  const { name, bytes } = await download(page, "JSON");
  expect(name).toBe("riverseed-puriri.json");
  expect(Object.keys(JSON.parse(bytes.toString("utf8"))).length).toBeGreaterThan(1);
});

test("a file can be had before the picture is finished, and is of the finished rivers", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, LINK);
  const { bytes } = await download(page, "GeoJSON");
  await stopClock(page);
  await page.getByRole("button", { name: "Restart" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  await page.clock.resume();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  expect((await download(page, "GeoJSON")).bytes.equals(bytes)).toBe(true);
});

test("the menu is used by keys, and gives the focus back", async ({ page }) => {
  await openFinished(page, LINK);
  const button = page.getByRole("button", { name: "Download" });
  const item = (name: string) => page.getByRole("menuitem", { name: new RegExp(`^${name} `) });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(button).toHaveAttribute("aria-expanded", "true");
  await expect(item("PNG")).toBeFocused();
  await page.keyboard.press("ArrowUp");
  await expect(item("JSON")).toBeFocused();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await expect(item("SVG")).toBeFocused();
  await page.keyboard.press("End");
  await expect(item("JSON")).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(button).toBeFocused();
  await expect(page.getByRole("menu")).toBeHidden();
  await page.keyboard.press("ArrowUp");
  await expect(item("JSON")).toBeFocused();
  await page.keyboard.press("Tab");
  await expect(page.getByRole("menu")).toBeHidden();
  await button.click();
  await page.locator("#title").click();
  await expect(page.getByRole("menu")).toBeHidden();
  await button.focus();
  await page.keyboard.press("ArrowDown");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  expect(download.suggestedFilename()).toBe("riverseed-puriri.png");
  await expect(button).toBeFocused();
});
