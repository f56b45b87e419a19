/** Real pieces, of Natural Earth (public domain): rivers of the world as maps show them, thinned to lines of a pixel. */

import { type Piece, SIDE } from "./piece.ts";
import rivers from "./real.json";
import sprite from "./real.png?url";
import { isTreeLike } from "./trace.ts";

/** The number of pieces side by side in the picture. */
const COLUMNS = 11;

export interface Real {
  /** The name of its greatest river; empty if it has none. */
  river: string;
  kilometresPerPixel: number;
  piece: Piece;
}

/** Loads the pieces that are as grown ones could be. */
export async function realPieces(): Promise<Real[]> {
  const pieces = await piecesIn(new Uint8Array(await (await fetch(sprite)).arrayBuffer()));
  return pieces.filter(({ piece }) => isTreeLike(piece));
}

/** Reads all pieces from the picture's file. */
export async function piecesIn(png: Uint8Array<ArrayBuffer>): Promise<Real[]> {
  const { width, pixels } = await bitsOf(png);
  return rivers.map((river, i) => {
    const first = Math.floor(i / COLUMNS) * SIDE * width + (i % COLUMNS) * SIDE;
    const pixel = (_: unknown, at: number): number => pixels[first + Math.floor(at / SIDE) * width + (at % SIDE)] ?? 0;
    return { ...river, piece: Uint8Array.from({ length: SIDE * SIDE }, pixel) };
  });
}

/**
 * Decodes a PNG of one bit a pixel, whose rows are unfiltered or differ from the row above. A canvas would do it, too,
 * but browsers that resist fingerprinting give other pixels back.
 */
async function bitsOf(png: Uint8Array<ArrayBuffer>): Promise<{ width: number; pixels: Uint8Array }> {
  const view = new DataView(png.buffer, png.byteOffset);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const bytes = await unpacked(png, view);
  // A row begins with its filter.
  const row = Math.ceil(width / 8) + 1;
  for (let at = row; at < bytes.length; at++)
    if (at % row !== 0 && bytes[at - (at % row)] === UP) bytes[at] = (bytes[at] ?? 0) + (bytes[at - row] ?? 0);
  const bit = (_: unknown, at: number): number => {
    const [x, y] = [at % width, Math.floor(at / width)];
    return ((bytes[y * row + 1 + (x >> 3)] ?? 0) >> (7 - (x & 7))) & 1;
  };
  return { width, pixels: Uint8Array.from({ length: width * height }, bit) };
}

/** The filter of rows that differ from the row above. */
const UP = 2;

/** Returns the data of a PNG, whose chunks follow its signature of eight bytes: length, name, data and checksum. */
async function unpacked(png: Uint8Array<ArrayBuffer>, view: DataView): Promise<Uint8Array> {
  const data: BlobPart[] = [];
  for (let at = 8; at < png.length; at += view.getUint32(at) + 12)
    if (view.getUint32(at + 4) === IDAT) data.push(png.subarray(at + 8, at + 8 + view.getUint32(at)));
  const stream = new Blob(data).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** “IDAT”. */
const IDAT = 0x49444154;
