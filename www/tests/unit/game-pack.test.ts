import { decode } from "fast-png";
import { strFromU8, unzipSync } from "fflate";
import { expect, test, vi } from "vitest";
import { contentsOf, packed } from "../../src/files/game-pack.ts";
import { engine } from "../whole.ts";

// An archive takes seconds, on a busy machine more.
vi.setConfig({ testTimeout: 60_000 });

const LINK = "seed=kauri&attractors=300&land=valley&style=ink&labels=none";

function finished(): engine.River {
  const river = new engine.River(LINK);
  while (river.advance(1000));
  return river;
}

async function unpacked(): Promise<Record<string, Uint8Array>> {
  const archive = await packed(contentsOf(finished()), new Blob(["a picture"]));
  return unzipSync(new Uint8Array(await archive.arrayBuffer()));
}

function bytesOf({ buffer, byteOffset, byteLength }: ArrayBufferView): Buffer {
  return Buffer.from(buffer as ArrayBuffer, byteOffset, byteLength);
}

test("the archive holds every file, and the picture as it came", async () => {
  const files = await unpacked();
  const rasters = ["heights.png", "land.png", "rivers.png", "flow.png", "basins.png", "water.png", "depth.png"];
  expect(Object.keys(files)).toEqual(["README.txt", ...rasters, "map.geojson", "map.png"]);
  expect(strFromU8(files["map.png"] ?? new Uint8Array())).toBe("a picture");
  expect(JSON.parse(strFromU8(files["map.geojson"] ?? new Uint8Array()))).toEqual(
    JSON.parse(JSON.stringify(finished().geojson())),
  );
  expect(strFromU8(files["README.txt"] ?? new Uint8Array())).toBe(finished().cells().readme());
});

test("rasters are read back as the engine has them, in 8 or 16 bits, with what they mean", async () => {
  const [files, { columns, rows, rasters }] = [await unpacked(), contentsOf(finished())];
  const depths = rasters.map(({ name, values, texts }) => {
    const picture = decode(files[`${name}.png`] ?? new Uint8Array());
    expect([picture.width, picture.height, picture.channels]).toEqual([columns, rows, 1]);
    // Compared one by one, a quarter of a million numbers would take seconds.
    expect(Buffer.compare(bytesOf(picture.data), bytesOf(values))).toBe(0);
    expect(picture.text).toEqual(texts);
    return picture.depth;
  });
  expect(depths).toEqual([16, 8, 16, 8, 16, 8, 16]);
  expect(rasters[0]?.texts["metres-a-step"]).toMatch(/^0\.\d{6}$/);
});

test("rasters have the size and the shape that were asked for, and the text says the scale and where the map lies", () => {
  const whole = contentsOf(finished(), { longerSide: 1025, isSquare: false });
  expect([whole.columns, whole.rows]).toEqual([1025, 641]);
  expect(whole.readme).toContain("A raster has 1025 x 641 pixels");
  expect(whole.readme).not.toContain("around it is sea");
  const square = contentsOf(finished(), { longerSide: 1025, isSquare: true });
  expect([square.columns, square.rows]).toEqual([1025, 1025]);
  expect(square.readme).toContain("The map takes 1025 x 641 of them, from column 0 and row 192, counted from 0");
  const unit = /\((\S+) units of the map\)/.exec(square.readme)?.[1];
  expect(unit).toBe(/\((\S+) units of the map\)/.exec(whole.readme)?.[1]);
  for (const [i, { values, texts }] of square.rasters.entries()) {
    const part = values.subarray(192 * 1025, (192 + 641) * 1025);
    expect(Buffer.compare(bytesOf(part), bytesOf(whole.rasters[i]?.values ?? new Uint8Array()))).toBe(0);
    expect(texts).toMatchObject({ "units-a-pixel": unit, "map-pixels": "1025 x 641 from 0, 192" });
  }
});

test("rasters of no possible size are refused in words", () => {
  for (const longerSide of [0, 400, 4098, 2 ** 32 - 1])
    expect(() => finished().cells(longerSide)).toThrow(
      `rasters of this map are from 633 to 4097 pixels long, not ${longerSide}`,
    );
});

test("a growing river has no rasters", () => {
  expect(() => contentsOf(new engine.River(LINK))).toThrow("not finished");
});

test("a river always gives the same archive", async () => {
  const made = async () => Buffer.from(await (await packed(contentsOf(finished()), new Blob(["x"]))).arrayBuffer());
  expect((await made()).equals(await made())).toBe(true);
});
