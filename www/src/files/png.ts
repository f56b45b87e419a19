/**
 * Encodes PNG files, some rows at a time. A browser's canvas cannot do it: the largest pictures are larger than many
 * browsers allow, some browsers change pixels slightly when they are read, and none reports progress.
 */

import type { Course } from "./course.ts";

export interface PngImage {
  width: number;
  height: number;
  pixels: Pixels;
  /** Returns the pixels of some rows, as they are in memory. They are valid until the next call. */
  rows(first: number, count: number): Uint8Array;
  /** Texts by keyword, in Latin-1. */
  texts: Readonly<Record<string, string>>;
  /** Dots per inch, if the picture has a size on paper. */
  dpi?: number | undefined;
}

/**
 * The kind of pixels. `rgb` and `rgba` are RGBA in memory, and are written without and with opacity; grey has 8 or 16
 * bits.
 */
export type Pixels = "rgb" | "rgba" | "grey8" | "grey16";

/** The format's colour type and bits per channel, and the bytes of a pixel in memory and in the file. */
interface Layout {
  colour: number;
  depth: number;
  inMemory: number;
  inFile: number;
}

const LAYOUTS: Readonly<Record<Pixels, Layout>> = {
  rgb: { colour: 2, depth: 8, inMemory: 4, inFile: 3 },
  rgba: { colour: 6, depth: 8, inMemory: 4, inFile: 4 },
  grey8: { colour: 0, depth: 8, inMemory: 1, inFile: 1 },
  grey16: { colour: 0, depth: 16, inMemory: 2, inFile: 2 },
};

/** The approximate number of bytes in memory that are written at a time. */
const BAND_BYTES = 1 << 19;

const SIGNATURE = new Uint8Array([137, 80, 78, 71, 13, 10, 26, 10]);

export async function pngOf(image: PngImage, course: Course): Promise<Blob> {
  const { texts, dpi } = image;
  const parts: BlobPart[] = [SIGNATURE, ...chunk("IHDR", header(image))];
  if (dpi !== undefined) parts.push(...chunk("pHYs", density(dpi)));
  for (const [keyword, text] of Object.entries(texts)) parts.push(...chunk("tEXt", latin(`${keyword}\0${text}`)));
  const zlib = new CompressionStream("deflate");
  const packing = collect(zlib.readable, (bytes) => parts.push(...chunk("IDAT", bytes)));
  await Promise.all([filter(image, zlib.writable, course), packing]);
  parts.push(...chunk("IEND", new Uint8Array()));
  return new Blob(parts, { type: "image/png" });
}

/** Writes rows, each after the number of its filter, into a stream that compresses them. */
async function filter(image: PngImage, packed: WritableStream<BufferSource>, course: Course): Promise<void> {
  const { width, height, pixels } = image;
  const writer = packed.getWriter();
  const filters = new RowFilters(width, LAYOUTS[pixels]);
  const most = Math.max(1, Math.floor(BAND_BYTES / (width * LAYOUTS[pixels].inMemory)));
  try {
    for (let first = 0; first < height; first += most) {
      const count = Math.min(most, height - first);
      await writer.ready;
      await writer.write(filters.filtered(image.rows(first, count), count));
      course.tell((first + count) / height);
      await course.pause();
    }
    await writer.close();
  } catch (error) {
    await writer.abort(error).catch(() => {});
    throw error;
  }
}

async function collect(stream: ReadableStream<Uint8Array>, take: (bytes: Uint8Array) => void): Promise<void> {
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    take(value);
  }
}

/** Filters rows. Each filter subtracts from a byte a prediction by the bytes before it. */
class RowFilters {
  readonly #length: number;
  #above: Uint8Array;
  #row: Uint8Array;
  /** The row after each filter, in the order in which the format numbers them from 1. */
  readonly #tried: Uint8Array[];

  constructor(
    width: number,
    private readonly layout: Layout,
  ) {
    this.#length = width * layout.inFile;
    this.#above = new Uint8Array(this.#length);
    this.#row = new Uint8Array(this.#length);
    this.#tried = [1, 2, 3, 4].map(() => new Uint8Array(this.#length));
  }

  /** Filters the next rows, each with the filter that leaves the least. */
  filtered(pixels: Uint8Array, count: number): Uint8Array<ArrayBuffer> {
    const filtered = new Uint8Array((this.#length + 1) * count);
    const bytes = pixels.length / count;
    for (let row = 0; row < count; row++) {
      this.#take(pixels, row * bytes);
      const best = this.#best();
      filtered[row * (this.#length + 1)] = best + 1;
      filtered.set(this.#tried[best] ?? this.#row, row * (this.#length + 1) + 1);
      [this.#above, this.#row] = [this.#row, this.#above];
    }
    return filtered;
  }

  /** Takes a row in the layout of the file: without opacity for `rgb`, and with the high byte of 16 bits first. */
  #take(pixels: Uint8Array, from: number): void {
    const row = this.#row;
    const { inMemory, inFile } = this.layout;
    if (inMemory === inFile) row.set(pixels.subarray(from, from + this.#length));
    for (let to = 0, at = from; inMemory > inFile && to < row.length; to += 3, at += 4) {
      row[to] = pixels[at] ?? 0;
      row[to + 1] = pixels[at + 1] ?? 0;
      row[to + 2] = pixels[at + 2] ?? 0;
    }
    if (this.layout.depth === 16) swapPairs(row);
  }

  /** Tries all filters. Returns the index of the one that leaves the least sum. */
  #best(): number {
    const [sub, up, average, paeth] = this.#tried;
    if (!sub || !up || !average || !paeth) return 0;
    const [row, above, step] = [this.#row, this.#above, this.layout.inFile];
    let [bySub, byUp, byAverage, byPaeth] = [0, 0, 0, 0];
    for (let i = 0; i < row.length; i++) {
      const here = row[i] ?? 0;
      const left = i < step ? 0 : (row[i - step] ?? 0);
      const upper = above[i] ?? 0;
      const corner = i < step ? 0 : (above[i - step] ?? 0);
      const afterSub = (here - left) & 255;
      sub[i] = afterSub;
      bySub += rest(afterSub);
      const afterUp = (here - upper) & 255;
      up[i] = afterUp;
      byUp += rest(afterUp);
      const afterAverage = (here - ((left + upper) >> 1)) & 255;
      average[i] = afterAverage;
      byAverage += rest(afterAverage);
      const afterPaeth = (here - likeliest(left, upper, corner)) & 255;
      paeth[i] = afterPaeth;
      byPaeth += rest(afterPaeth);
    }
    const sums = [bySub, byUp, byAverage, byPaeth];
    return sums.indexOf(Math.min(...sums));
  }
}

/** Swaps the bytes of 16-bit numbers, which are little-endian on every machine with a browser. */
function swapPairs(row: Uint8Array): void {
  for (let i = 0; i < row.length; i += 2) [row[i], row[i + 1]] = [row[i + 1] ?? 0, row[i] ?? 0];
}

/** Returns the distance of a byte from 0, in either direction. */
function rest(byte: number): number {
  return byte < 128 ? byte : 256 - byte;
}

/** Returns Paeth's prediction of a byte: the neighbour that is nearest to left + upper - corner. */
function likeliest(left: number, upper: number, corner: number): number {
  const byLeft = Math.abs(upper - corner);
  const byUpper = Math.abs(left - corner);
  const byCorner = Math.abs(left + upper - 2 * corner);
  if (byLeft <= byUpper && byLeft <= byCorner) return left;
  return byUpper <= byCorner ? upper : corner;
}

function header({ width, height, pixels }: PngImage): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(13);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  bytes.set([LAYOUTS[pixels].depth, LAYOUTS[pixels].colour], 8);
  return bytes;
}

const METRES_AN_INCH = 0.0254;

/** Returns the dots per metre in either direction, and the number that says that they are counted by the metre. */
function density(dpi: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(9);
  const view = new DataView(bytes.buffer);
  for (const at of [0, 4]) view.setUint32(at, Math.round(dpi / METRES_AN_INCH));
  bytes[8] = 1;
  return bytes;
}

function latin(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

/** Makes a chunk: its length, name and bytes, and their checksum. */
function chunk(name: string, bytes: Uint8Array): BlobPart[] {
  const head = new Uint8Array(8);
  new DataView(head.buffer).setUint32(0, bytes.length);
  head.set(latin(name), 4);
  const check = new Uint8Array(4);
  new DataView(check.buffer).setUint32(0, ~crc(bytes, crc(head.subarray(4), ~0)));
  return [head, bytes as Uint8Array<ArrayBuffer>, check];
}

/** The remainders of all bytes by the polynomial of PNG's checksum. */
const REMAINDERS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit++) rest = rest & 1 ? 0xedb88320 ^ (rest >>> 1) : rest >>> 1;
  return rest;
});

function crc(bytes: Uint8Array, before: number): number {
  let rest = before;
  for (const byte of bytes) rest = (REMAINDERS[(rest ^ byte) & 255] ?? 0) ^ (rest >>> 8);
  return rest;
}
