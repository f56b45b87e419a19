import { decode } from "fast-png";
import { expect, test } from "vitest";
import type { Course } from "../../src/files/course.ts";
import { pngOf } from "../../src/files/png.ts";

const still: Course = { tell: () => {}, pause: () => Promise.resolve() };

/** A picture with even places, slopes and noise. */
function image(width: number, height: number, isTransparent: boolean) {
  const pixels = new Uint8Array(width * height * 4);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const noise = Math.imul(i + 1, 0x9e3779b1) >>> 24;
    pixels.set([x < 9 ? 77 : (x * 3 + y) & 255, (x + y * 2) & 255, noise, isTransparent ? (y * 7) & 255 : 255], i * 4);
  }
  const rows = (first: number, count: number) => pixels.slice(first * width * 4, (first + count) * width * 4);
  const texts = { riverseed: "seed=a%C4%81" };
  return { width, height, rows, pixels: isTransparent ? ("rgba" as const) : ("rgb" as const), texts, bytes: pixels };
}

test.each([
  [1, 1, false],
  [37, 23, false],
  [37, 23, true],
  [2000, 300, false],
])("a picture of %i × %i comes out as it was put in (opacity: %s)", async (width, height, isTransparent) => {
  const picture = image(width, height, isTransparent);
  const shares: number[] = [];
  const file = await pngOf(picture, { ...still, tell: (share) => shares.push(share) });
  expect(file.type).toBe("image/png");
  const read = decode(await file.arrayBuffer(), { checkCrc: true });
  const channels = isTransparent ? 4 : 3;
  expect([read.width, read.height, read.channels, read.depth]).toEqual([width, height, channels, 8]);
  expect(read.text).toEqual({ riverseed: "seed=a%C4%81" });
  const expected = isTransparent ? picture.bytes : picture.bytes.filter((_, i) => i % 4 !== 3);
  expect(Buffer.from(read.data as Uint8Array).equals(Buffer.from(expected))).toBe(true);
  expect(shares).toEqual([...shares].sort((a, b) => a - b));
  expect(shares.at(-1)).toBe(1);
});

test.each([
  ["grey8", Uint8Array.from({ length: 37 * 23 }, (_, i) => i * 7)],
  ["grey16", Uint16Array.from({ length: 37 * 23 }, (_, i) => i * 777)],
] as const)("numbers come out of a picture of %s as they were put in", async (pixels, numbers) => {
  const bytes = new Uint8Array(numbers.buffer);
  const length = bytes.length / 23;
  const rows = (first: number, count: number) => bytes.subarray(first * length, (first + count) * length);
  const file = await pngOf({ width: 37, height: 23, pixels, rows, texts: {} }, still);
  const read = decode(await file.arrayBuffer(), { checkCrc: true });
  expect([read.width, read.height, read.channels, read.depth]).toEqual([37, 23, 1, pixels === "grey8" ? 8 : 16]);
  expect([...read.data]).toEqual([...numbers]);
});

test("a picture for print says its dots per inch, in whole dots per metre, and any other says nothing", async () => {
  const printed = decode(await (await pngOf({ ...image(3, 2, false), dpi: 300 }, still)).arrayBuffer(), {
    checkCrc: true,
  });
  expect(printed.resolution).toEqual({ x: 11_811, y: 11_811, unit: 1 });
  const shown = decode(await (await pngOf(image(3, 2, false), still)).arrayBuffer());
  expect(shown.resolution).toBeUndefined();
});

test("what smooth ground takes is little: a row is written as what differs from those before it", async () => {
  const width = 500;
  const slope = new Uint8Array(width * width * 4).map((_, i) => ((i >> 2) % width) / 2 + (i >> 2) / width / 2);
  const rows = (first: number, count: number) => slope.slice(first * width * 4, (first + count) * width * 4);
  const file = await pngOf({ width, height: width, rows, pixels: "rgb", texts: {} }, still);
  expect(file.size).toBeLessThan(width * width * 3 * 0.02);
});

test("a picture that is no longer wanted is not written to its end", async () => {
  const picture = image(3000, 2000, false);
  let asked = 0;
  const course: Course = {
    tell: () => {},
    pause: () => (++asked > 3 ? Promise.reject(new DOMException("stop", "AbortError")) : Promise.resolve()),
  };
  await expect(pngOf(picture, course)).rejects.toThrow("stop");
  expect(asked).toBe(4);
});
