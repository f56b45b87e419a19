/**
 * Makes files of finished rivers in every format that the page offers. Separate from `files.ts`, so that widgets need
 * not load the archiver.
 */

import type { FullCore, FullRiver } from "../engine/full.ts";
import { askChartForFile } from "../player/chart-maker.ts";
import { finished, inSlices, LONG_SIDE_PX, type Painting, picture, svgOf } from "./files.ts";
import type { Format } from "./format-names.ts";
import { contentsOf, packed } from "./game-pack.ts";

/** The full engine, with the charts module, since all data files contain names. */
export type FileCore = FullCore & Painting;

const FORMATS: Record<Format, (river: FullRiver, core: FileCore) => Promise<Blob>> = {
  svg: svgOf,
  geojson: (river, core) =>
    raised(river, async () => text(river.geojson(await namesOf(river, core)), "application/geo+json")),
  json: (river, core) =>
    finished(river, async () => text(river.network(await namesOf(river, core)), "application/json")),
  zip: packOf,
};

/** Grows a river to its end and makes a file of it. Takes over the river, and frees it afterwards. */
export function fileOf(river: FullRiver, core: FileCore, format: Format): Promise<Blob> {
  return FORMATS[format](river, core);
}

/** Packs the picture and the other files that games need. */
async function packOf(river: FullRiver, core: FileCore): Promise<Blob> {
  const [contents, map] = await raised(river, async () => {
    const contents = contentsOf(river, await namesOf(river, core));
    return [contents, await picture(river, core, LONG_SIDE_PX)] as const;
  });
  core.holdOn();
  return packed(contents, map);
}

/** Grows a river to its end with its relief, even in a style that shows none, and makes something of it. */
function raised<Made>(river: FullRiver, make: () => Made | Promise<Made>): Promise<Made> {
  return finished(river, async () => {
    await inSlices(() => river.raiseRelief());
    return make();
  });
}

function namesOf(river: FullRiver, core: FileCore): Promise<Uint32Array> {
  return askChartForFile(river, core, (chart) => chart.names());
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}
