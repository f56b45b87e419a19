/** A map's files for a game, as one archive: rasters, rivers, the picture, and a text that says by which scale. */

import { encode } from "fast-png";
import { strToU8, zipSync } from "fflate";
import type { FullRiver } from "../engine/full.ts";

/** What the archive is made of, out of the engine's memory. */
export interface Contents {
  readme: string;
  geojson: string;
  columns: number;
  rows: number;
  rasters: Raster[];
}

interface Raster {
  name: string;
  values: Uint8Array | Uint16Array;
  texts: Record<string, string>;
}

export function contentsOf(river: FullRiver, names: Uint32Array): Contents {
  const cells = river.cells();
  try {
    const { columns, rows } = cells;
    const rasters = cells.names().flatMap((name, number) => {
      const values = cells.values(number);
      return values ? [{ name, values, texts: paired(cells.texts(number)) }] : [];
    });
    return { readme: cells.readme(), geojson: JSON.stringify(river.geojson(names)), columns, rows, rasters };
  } finally {
    cells.free();
  }
}

/** The archive. */
export function packed({ readme, geojson, columns, rows, rasters }: Contents, picture: ArrayBuffer): Blob {
  const files: Record<string, Uint8Array> = { "README.txt": strToU8(readme) };
  for (const { name, values, texts } of rasters) {
    const depth = values instanceof Uint16Array ? 16 : 8;
    files[`${name}.png`] = encode({ width: columns, height: rows, data: values, depth, channels: 1, text: texts });
  }
  files["map.geojson"] = strToU8(geojson);
  files["map.png"] = new Uint8Array(picture);
  return new Blob([zipSync(files, { mtime: EARLIEST })], { type: "application/zip" });
}

/** Files have no time, so that a river always gives the same archive: the first day that the format knows. */
const EARLIEST = new Date(1980, 0, 1);

/** Keywords and texts in turn, as an object. */
function paired(texts: string[]): Record<string, string> {
  return Object.fromEntries(texts.flatMap((key, i) => (i % 2 === 0 ? [[key, texts[i + 1] ?? ""]] : [])));
}
