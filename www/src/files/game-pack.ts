/** A map's files for a game, in one archive: rasters, rivers, the picture, and a text that gives the scale. */

import { strToU8, zipSync } from "fflate";
import type { Raster } from "../engine/types.ts";
import type { WholeRiver } from "../engine/whole.ts";
import { SILENT } from "./files.ts";
import type { RasterOrder } from "./format-names.ts";
import { pngOf } from "./png.ts";

/** The contents of an archive, copied out of the engine's memory. */
export interface Contents {
  readme: string;
  geojson: string;
  columns: number;
  rows: number;
  rasters: Raster[];
}

export function contentsOf(river: WholeRiver, order?: RasterOrder): Contents {
  const cells = river.cells(order?.longerSide, order?.isSquare);
  try {
    const { columns, rows } = cells;
    const geojson = JSON.stringify(river.geojson());
    return { readme: cells.readme(), geojson, columns, rows, rasters: cells.rasters() };
  } finally {
    cells.free();
  }
}

/** Makes the archive, with the picture of the map. */
export async function packed({ readme, geojson, columns, rows, rasters }: Contents, map: Blob): Promise<Blob> {
  const files: Record<string, Uint8Array> = { "README.txt": strToU8(readme) };
  for (const raster of rasters) files[`${raster.name}.png`] = await bytesOf(await rasterPng(raster, columns, rows));
  files["map.geojson"] = strToU8(geojson);
  files["map.png"] = await bytesOf(map);
  return new Blob([zipSync(files, { mtime: EARLIEST })], { type: "application/zip" });
}

function rasterPng({ values, texts }: Raster, width: number, height: number): Promise<Blob> {
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  const length = width * values.BYTES_PER_ELEMENT;
  const rows = (first: number, count: number): Uint8Array => bytes.subarray(first * length, (first + count) * length);
  return pngOf({ width, height, pixels: values instanceof Uint16Array ? "grey16" : "grey8", rows, texts }, SILENT);
}

async function bytesOf(file: Blob): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

/** The date of all files, the first that the format knows, so that a river always gives the same archive. */
const EARLIEST = new Date(1980, 0, 1);
