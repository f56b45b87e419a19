/** Reads the pixels of a visitor's picture file, within the size that the core accepts. */

import { PageError } from "../../../engine/errors.ts";

/** The largest file in bytes. A picture of a coast is never larger. */
const LARGEST_FILE = 64 * 1024 * 1024;

export interface Pixels {
  /** RGBA, four bytes per pixel. */
  rgba: Uint8Array;
  width: number;
  height: number;
}

/** Returns the pixels of a picture in a file. The size of a PNG is checked before it is decoded. */
export async function pixelsOf(file: Blob, longestSide: number): Promise<Pixels> {
  if (file.size > LARGEST_FILE) throw new PageError("bad-image", "This file is too large: over 64 MB.");
  checkSize(pngSize(new Uint8Array(await file.slice(0, 24).arrayBuffer())), longestSide);
  const bitmap = await decode(file);
  try {
    checkSize(bitmap, longestSide);
    return read(bitmap);
  } finally {
    bitmap.close();
  }
}

async function decode(file: Blob): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(file, { premultiplyAlpha: "none", colorSpaceConversion: "none" });
  } catch {
    throw new PageError("bad-image", "The browser cannot read this file as a picture: a PNG is best.");
  }
}

function checkSize(size: { width: number; height: number } | undefined, longestSide: number): void {
  if (!size || Math.max(size.width, size.height) <= longestSide) return;
  const pixels = `${size.width} × ${size.height} pixels`;
  throw new PageError(
    "bad-image",
    `This picture is too large: ${pixels}, at most ${longestSide} × ${longestSide} are traced.`,
  );
}

function read(bitmap: ImageBitmap): Pixels {
  const { width, height } = bitmap;
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new PageError("bad-image", "The browser has no memory left to read this picture.");
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  return { rgba: new Uint8Array(data.buffer), width, height };
}

/** Reads the size from the header of a PNG; returns nothing for other files. */
export function pngSize(head: Uint8Array): { width: number; height: number } | undefined {
  const signature = [137, 80, 78, 71, 13, 10, 26, 10];
  if (head.length < 24 || signature.some((byte, i) => head[i] !== byte)) return undefined;
  const view = new DataView(head.buffer, head.byteOffset);
  return { width: view.getUint32(16), height: view.getUint32(20) };
}
