import { decode } from "fast-png";
import { unzipSync } from "fflate";
import { expect, test, vi } from "vitest";
import { picture, pngOf } from "../../src/files/files.ts";
import { fileOf } from "../../src/files/formats.ts";
import { pictureOf } from "../../src/files/picture.ts";
import { differing, pixelsOf } from "../core.ts";
import { engine, memory } from "../whole.ts";

// Files take seconds, on a busy machine more.
vi.setConfig({ testTimeout: 60_000 });

const LINK = "seed=kauri&attractors=300&meander-rounds=5&labels=none";
const core = { engine, memory, holdOn: () => {} };

function grown(steps: number): engine.River {
  const river = new engine.River(LINK);
  river.advance(steps);
  return river;
}

const json = async (river: engine.River): Promise<object> =>
  JSON.parse(await (await fileOf(river, core, "json")).text());

for (const steps of [0, 10, 100_000]) {
  test(`a copy of a river after ${steps} steps becomes the finished file, and the river stays as it is`, async () => {
    const river = grown(steps);
    const summary = river.summary();
    expect(await json(river.copy())).toEqual(await json(grown(0)));
    expect(river.summary()).toEqual(summary);
  });
}

test("a copy goes its own way, and says so", () => {
  const river = grown(10);
  const copy = river.copy();
  expect(copy.link).toBe(river.link);
  expect(copy.change("seed=rimu&attractors=100")).toBe("land");
  copy.advance(100_000);
  expect([river.seed, river.phase, copy.seed, copy.phase]).toEqual(["kauri", "growing", "rimu", "finished"]);
});

test("a river is gone once it is a file, and also if it could not be made one", async () => {
  const gone = (river: engine.River): unknown => {
    try {
      return river.phase;
    } catch (error) {
      return error;
    }
  };
  const river = grown(0);
  await fileOf(river, core, "svg");
  expect(gone(river)).toBeInstanceOf(Error);
  const unlucky = grown(0);
  Object.assign(unlucky, {
    svg: () => {
      throw new Error("no room");
    },
  });
  await expect(fileOf(unlucky, core, "svg")).rejects.toThrow("no room");
  expect(gone(unlucky)).toBeInstanceOf(Error);
});

const LABELLED = "seed=kauri&land=island&growth=drainage&attractors=1500&labels=many";

test("files of data have names, labels or not, and a shape has labels if they are asked for", async () => {
  const data = async (format: "json" | "geojson"): Promise<string> =>
    (await fileOf(new engine.River(LINK), core, format)).text();
  const network = JSON.parse(await data("json"));
  expect(network.names[0]).toMatchObject({ kind: "title", text: expect.stringMatching(/\w/) });
  expect(network.rivers[0]).toMatchObject({ identity: expect.any(Number), name: expect.stringMatching(/\w/) });
  const rivers = JSON.parse(await data("geojson")).features.filter(
    ({ properties }: { properties: { kind: string } }) => properties.kind === "river",
  );
  expect(rivers[0].properties.name).toBe(network.rivers[0].name);
  const shape = async (link: string): Promise<string> => (await fileOf(new engine.River(link), core, "svg")).text();
  expect(await shape(LINK)).not.toContain('id="labels"');
  const labelled = await shape(LABELLED);
  expect(labelled).toMatch(/<mask id="(halo-\d+)"[\s\S]*mask="url\(#\1\)[\s\S]*<g id="labels"[\s\S]*<title>\w/);
});

test("a picture for a file has its labels", async () => {
  const [bare, labelled] = [LABELLED.replace("labels=many", "labels=none"), LABELLED].map(async (link) => {
    const river = new engine.River(link);
    while (river.advance(1000));
    await picture(river, core, 300);
    return pixelsOf(river);
  });
  expect(differing((await bare) as Uint8Array, (await labelled) as Uint8Array)).toBeGreaterThan(200);
});

/** The pixels of a PNG. */
function decoded(png: ArrayBuffer): Uint8Array {
  return decode(png, { checkCrc: true }).data as Uint8Array;
}

/** The pixels that a fresh engine paints, without their opacity. */
function painted(link: string, longSide: number): Uint8Array {
  const river = new engine.River(link);
  while (river.advance(1000));
  const [width = 0, height = 0] = river.sidesFor(longSide);
  river.resize(width, height);
  while (river.paint());
  return pixelsOf(river).filter((_, i) => i % 4 !== 3);
}

test("the element's picture has exactly the core's pixels, and is the page's file to the byte", async () => {
  for (const link of [`${LINK}&style=atlas`, `${LINK}&aspect=0.7&style=ink`]) {
    const ofElement = await (await pngOf(new engine.River(link), core, 600)).arrayBuffer();
    expect(Buffer.compare(decoded(ofElement), painted(link, 600)), link).toBe(0);
    const order = { kind: "picture", link, longerSide: 600, isTransparent: false } as const;
    const ofPage = await pictureOf(order, core, { tell: () => {}, pause: () => Promise.resolve() });
    expect(Buffer.compare(Buffer.from(ofElement), Buffer.from(await ofPage.arrayBuffer())), link).toBe(0);
  }
});

test("a sheet of paper lies as the map does, shows all of it in the middle, and is as the map's ground to its edges", async () => {
  for (const [aspect, width, height] of [
    [1.6, 707, 500],
    [1, 707, 500],
    [0.6, 500, 707],
  ] as const) {
    const link = `seed=kauri&attractors=300&land=island&style=atlas&labels=some&aspect=${aspect}`;
    const order = { kind: "picture", link, longerSide: 707, shorterSide: 500, dpi: 300, isTransparent: false } as const;
    const sheet = await pictureOf(order, core, { tell: () => {}, pause: () => Promise.resolve() });
    const picture = decode(await sheet.arrayBuffer(), { checkCrc: true });
    expect([picture.width, picture.height, picture.resolution?.x]).toEqual([width, height, 11_811]);
    const river = new engine.River(link);
    while (river.advance(1000));
    river.resize(width, height);
    const across = Math.max(1, width / height / aspect);
    river.frame(new Float32Array([(1 - across) / 2, (1 / aspect - across / (width / height)) / 2, across]));
    while (river.paint());
    const framed = pixelsOf(river).filter((_, i) => i % 4 !== 3);
    // Map and labels lie where they should, to a small part of a pixel.
    const apart = framed.filter((value, i) => Math.abs(value - (picture.data[i] ?? 0)) > 8).length;
    expect(apart / framed.length, link).toBeLessThan(0.001);
    // The corners are sea, as is the map's own edge.
    const pixel = (x: number, y: number) => [...picture.data.subarray((y * width + x) * 3, (y * width + x) * 3 + 3)];
    expect(pixel(0, 0)).toEqual(pixel(width - 1, height - 1));
  }
});

test("a game pack's picture has exactly the core's pixels, and carries its link", async () => {
  const link = "seed=kauri&attractors=300&land=valley&style=atlas&labels=none";
  const pack = await (await fileOf(new engine.River(link), core, "zip")).arrayBuffer();
  const map = unzipSync(new Uint8Array(pack))["map.png"] ?? new Uint8Array();
  const { data, text } = decode(map, { checkCrc: true });
  expect(Buffer.compare(data as Uint8Array, painted(link, 3000))).toBe(0);
  expect(text).toEqual({ riverseed: new engine.River(link).fileLink });
});
