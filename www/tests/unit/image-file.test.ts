import { expect, test } from "vitest";
import { pixelsOf, pngSize } from "../../src/apps/page/land/image-file.ts";

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
