/**
 * Makes files of finished rivers in every format that the page offers. Separate from `files.ts`, so that widgets need
 * not load the archiver.
 */

import type { WholeCore, WholeRiver } from "../engine/whole.ts";
import { finished, inSlices, LONG_SIDE_PX, type Painting, picture, svgOf } from "./files.ts";
import type { Format, RasterOrder } from "./format-names.ts";
import { contentsOf, packed } from "./game-pack.ts";

/** An engine, with the means of painting a file. */
export type FileCore = WholeCore & Painting;

const FORMATS: Record<Format, (river: WholeRiver, core: FileCore, rasters?: RasterOrder) => Promise<Blob>> = {
  svg: svgOf,
  geojson: (river, core) => raised(river, core, () => text(river.geojson(), "application/geo+json")),
  json: (river, { holdOn }) =>
    finished(river, () => {
      holdOn();
      return text(river.network(), "application/json");
    }),
  zip: packOf,
};

/**
 * Grows a river to its end and makes a file of it. Takes over the river, and frees it afterwards. `rasters` is for a game
 * pack; without it, they have the map's own cells.
 */
export function fileOf(river: WholeRiver, core: FileCore, format: Format, rasters?: RasterOrder): Promise<Blob> {
  return FORMATS[format](river, core, rasters);
}

/** Packs the picture and the other files that games need. */
async function packOf(river: WholeRiver, core: FileCore, rasters?: RasterOrder): Promise<Blob> {
  const [contents, map] = await raised(river, core, async () => {
    const contents = contentsOf(river, rasters);
    return [contents, await picture(river, core, LONG_SIDE_PX)] as const;
  });
  core.holdOn();
  return packed(contents, map);
}

/** Grows a river to its end with its relief, even in a style that shows none, and makes something of it. */
function raised<Made>(river: WholeRiver, { holdOn }: FileCore, make: () => Made | Promise<Made>): Promise<Made> {
  return finished(river, async () => {
    await inSlices(() => river.raiseRelief());
    holdOn();
    return make();
  });
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}
