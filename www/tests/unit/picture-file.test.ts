import { expect, test } from "vitest";
import { nearestAspect, pixelsOf, pngSize } from "../../src/picture-file.ts";
import { rangeOf } from "../../src/values.ts";
import { parameter } from "../core.ts";

function head(width: number, height: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(24);
  bytes.set([137, 80, 78, 71, 13, 10, 26, 10]);
  new DataView(bytes.buffer).setUint32(16, width);
  new DataView(bytes.buffer).setUint32(20, height);
  return bytes;
}

test("the size of a PNG is read from its head, and of nothing else", () => {
  expect(pngSize(head(640, 70_000))).toEqual({ width: 640, height: 70_000 });
  expect(pngSize(head(1, 1).subarray(0, 20))).toBeUndefined();
  expect(pngSize(new Uint8Array(24))).toBeUndefined();
});

test("a picture that is too large is refused before it is unpacked", async () => {
  await expect(pixelsOf(new Blob([head(4097, 5)]), 4096)).rejects.toThrow("4097 × 5 pixels, at most 4096 × 4096");
});

test("a picture's aspect is brought into the range of the recipe", () => {
  const range = rangeOf(parameter("aspect"));
  if (!range) throw new Error("aspect has no range");
  expect(nearestAspect({ width: 300, height: 200 }, range)).toBe("1.5");
  expect(nearestAspect({ width: 640, height: 481 }, range)).toBe("1.33");
  expect(nearestAspect({ width: 9000, height: 10 }, range)).toBe(String(range.max));
  expect(nearestAspect({ width: 10, height: 9000 }, range)).toBe(String(range.min));
});
