import { expect, test } from "@playwright/test";
import { decode } from "fast-png";
import { strFromU8, unzipSync } from "fflate";
import { pictureOf } from "../core.ts";
import { engine } from "../whole.ts";
import { complaints, countCalls, openBegun, openFinished, ownClock, stopClock } from "./riverpage.ts";
import { bytesOf, choose, download, saveButton, saved, saving } from "./saving.ts";
import { core } from "./tiers.ts";

const LINK = "seed=puriri&attractors=300&style=ink&labels=none";
/** The same on a plain rectangle, whose rivers run south, for long enough to leave lakes. */
const PLAIN = `${LINK}&land=rectangle&aspect=1.5&sides=s&great-rivers=9&meander-elsewhere=1&meander-rounds=120&meander-strength=1`;

interface Feature {
  geometry: { type: string; coordinates: [number, number, number][] };
  properties: { kind: string; parent?: number | null };
}

for (const style of ["ink", "dark", "atlas", "night", "skeleton"]) {
  test(`an SVG, shown by a browser, is the picture of the page: ${style}${core(style === "ink")}`, async ({ page }) => {
    const said = complaints(page);
    await openFinished(page, `${LINK.replace("style=ink", `style=${style}`)}&aspect=1.5&land=island`);
    const { name, bytes } = await download(page, "Drawing");
    expect(name).toBe(`puriri-${style}.svg`);
    const seen = await page.evaluate(async (source) => {
      const image = new Image();
      image.src = `data:image/svg+xml;base64,${source}`;
      await image.decode();
      const pixels = (picture: CanvasImageSource, { x, y, width, height }: DOMRect): Uint8ClampedArray => {
        const canvas = Object.assign(document.createElement("canvas"), { width: 300, height: 200 });
        const context = canvas.getContext("2d");
        if (!context) throw new Error("no context");
        context.imageSmoothingQuality = "high";
        context.drawImage(picture, x, y, width, height, 0, 0, 300, 200);
        return context.getImageData(0, 0, 300, 200).data;
      };
      const shown = document.querySelector<HTMLCanvasElement>("#canvas");
      const map = document.querySelector("#map-place")?.getBoundingClientRect();
      if (!shown || !map) throw new Error("no picture");
      const whole = new DOMRect(0, 0, image.naturalWidth, image.naturalHeight);
      const [drawn, expected] = [pixels(image, whole), pixels(shown, map)];
      const differing = drawn.filter((channel, i) => Math.abs(channel - (expected[i] ?? 0)) > 60).length;
      const colours = new Set(new Uint32Array(expected.buffer)).size;
      return { width: image.naturalWidth, height: image.naturalHeight, differing: differing / drawn.length, colours };
    }, bytes.toString("base64"));
    expect(seen.width / seen.height).toBeCloseTo(1.5, 1);
    expect(seen.width).toBeGreaterThan(100);
    // The same picture, but for edges; and a picture, not a blank sheet.
    expect(seen.differing).toBeLessThan(0.01);
    expect(seen.colours).toBeGreaterThan(10);
    expect(said).toEqual([]);
  });
}

/** What the core writes of a link's finished rivers. */
function dataOf(link: string): { network: object; geojson: object } {
  const river = new engine.River(link);
  while (river.advance(1000));
  const [network, geojson] = [river.network(), river.geojson()];
  river.free();
  return { network: plain(network), geojson: plain(geojson) };
}

/** As it comes back from a file. */
function plain(value: object): object {
  return JSON.parse(JSON.stringify(value));
}

test("GeoJSON holds every river and lake, with the north up @core", async ({ page }) => {
  await openFinished(page, PLAIN);
  const { name, bytes } = await download(page, "Map data");
  expect(name).toBe("puriri.geojson");
  const file = JSON.parse(bytes.toString("utf8"));
  expect(file).toEqual(dataOf(PLAIN).geojson);
  const { sources, mouths } = pictureOf(PLAIN, 16, 16).summary;
  const rivers = file.features.filter(({ properties }: Feature) => properties.kind === "river");
  const toSea = rivers.filter(({ properties }: Feature) => properties.parent === null);
  expect([rivers.length, toSea.length]).toEqual([sources, mouths]);
  for (const { geometry } of toSea) {
    // 200 by 133 kilometres, of which 111.32 are a degree, around 0, 0: the sea is in the south.
    expect(geometry.coordinates.at(-1)?.[1]).toBeCloseTo(-0.59888, 4);
    for (const [east, north] of geometry.coordinates) {
      expect(Math.abs(east)).toBeLessThan(0.89832);
      expect(Math.abs(north)).toBeLessThan(0.59889);
    }
  }
});

test("JSON holds the whole network @core", async ({ page }) => {
  await openFinished(page, PLAIN);
  const { name, bytes } = await download(page, "Network");
  expect(name).toBe("puriri.json");
  const file = JSON.parse(bytes.toString("utf8"));
  expect(file).toEqual(dataOf(PLAIN).network);
  expect(Object.keys(file)).toEqual([
    "recipe",
    "resolved",
    "domain",
    "growth",
    "measures",
    "pattern",
    "nodes",
    "rivers",
    "oxbows",
    "lakes",
    "distributaries",
    "deltas",
    "names",
  ]);
  const { nodes, sources, oxbows } = pictureOf(PLAIN, 16, 16).summary;
  expect(Object.values<number[]>(file.nodes).map((column) => column.length)).toEqual(Array(8).fill(nodes));
  expect([file.rivers.length, file.oxbows.length]).toEqual([sources, oxbows]);
  expect(file.recipe).toMatchObject({ seed: "puriri", attractors: 300, land: "rectangle" });
});

test("the game pack holds rasters, rivers, the picture and a text @core", async ({ page }) => {
  const said = complaints(page);
  await openFinished(page, LINK);
  const { name, bytes } = await download(page, "Game pack");
  expect(name).toBe("puriri-ink.zip");
  const files = unzipSync(new Uint8Array(bytes));
  const heights = decode(files["heights.png"] ?? new Uint8Array());
  expect([heights.depth, heights.channels]).toEqual([16, 1]);
  expect(JSON.parse(strFromU8(files["map.geojson"] ?? new Uint8Array()))).toEqual(dataOf(LINK).geojson);
  expect(decode(files["map.png"] ?? new Uint8Array()).width).toBe(3000);
  expect(strFromU8(files["README.txt"] ?? new Uint8Array())).toContain("seed=puriri");
  expect(said).toEqual([]);
});

test("a game pack has rasters of the size and shape that were chosen, by five clicks from the map", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await saving(page)
    .getByRole("radio", { name: /^Game pack/ })
    .click();
  await saving(page).getByRole("radio", { name: "2049" }).click();
  await saving(page).getByRole("radio", { name: "Square" }).click();
  const files = unzipSync(new Uint8Array((await saved(page)).bytes));
  for (const name of ["heights", "land", "rivers", "flow", "basins"]) {
    const raster = decode(files[`${name}.png`] ?? new Uint8Array());
    expect([raster.width, raster.height], name).toEqual([2049, 2049]);
  }
  expect(strFromU8(files["README.txt"] ?? new Uint8Array())).toContain("A raster has 2049 x 2049 pixels");
});

test("a file can be had before the picture is finished, and is of the finished rivers", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, LINK);
  const { bytes } = await download(page, "Map data");
  await stopClock(page);
  await page.getByRole("button", { name: "Replay" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  await page.clock.resume();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  const shown = await page.locator("#caption").textContent();
  expect((await download(page, "Map data")).bytes.equals(bytes)).toBe(true);
  // The rivers on show are left as they are.
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  expect(await page.locator("#caption").textContent()).toBe(shown);
  await page.getByRole("button", { name: "Play" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished");
});

test("for data and shapes of finished rivers nothing is fetched but what names them, once, and nothing grown again", async ({
  page,
}) => {
  const created = await countCalls(page, "river_new");
  const advanced = await countCalls(page, "river_advance");
  // There is no room for small pictures, which are made of a river, too.
  await page.setViewportSize({ width: 844, height: 390 });
  await openFinished(page, LINK);
  const fetched: string[] = [];
  page.on("request", (request) => fetched.push(request.url()));
  const { inWorker: before } = await advanced();
  const formats = ["Drawing", "Map data", "Network", "Game pack"];
  for (const format of formats) await download(page, format);
  expect(await created()).toEqual({ onPage: 0, inWorker: 1 });
  // Each is asked once whether there is more to do.
  expect(await advanced()).toEqual({ onPage: 0, inWorker: before + formats.length });
  expect(fetched.filter((url) => !url.startsWith("blob:"))).toEqual([]);
});

test("a file is of what the page showed when it was asked for, whatever is on the canvas", async ({ page }) => {
  await openBegun(page, LINK);
  const seed = page.getByLabel("Seed", { exact: true });
  // No frame comes, so the canvas still has the first rivers.
  await seed.fill("rimu");
  await seed.press("Enter");
  await expect(page.locator("#title")).toHaveText("rimu");
  await choose(page, "Network");
  const coming = page.waitForEvent("download");
  await saveButton(page).click();
  await page.keyboard.press("Escape");
  await seed.fill("miro");
  await seed.press("Enter");
  await page.clock.resume();
  const file = await coming;
  expect(file.suggestedFilename()).toBe("rimu.json");
  const expected = dataOf(LINK.replace("puriri", "rimu")).network;
  expect(JSON.parse((await bytesOf(file)).toString("utf8"))).toEqual(expected);
});
