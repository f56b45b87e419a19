/** Finished rivers in every format that the page offers. A module of its own: widgets need not load what writes archives. */

import type { FullCore, FullRiver } from "../engine/full.ts";
import { askChartForFile } from "../player/chart-maker.ts";
import { drawn, encoded, finished, inSlices, LONG_SIDE_PX, type Painting, svgOf } from "./files.ts";
import type { Format } from "./format-names.ts";
import { contentsOf, packed } from "./game-pack.ts";

/** The full engine, with what makes charts: all files of data have names. */
export type FileCore = FullCore & Painting;

const FORMATS: Record<Format, (river: FullRiver, core: FileCore) => Promise<Blob>> = {
  svg: svgOf,
  geojson: (river, core) =>
    raised(river, async () => text(river.geojson(await namesOf(river, core)), "application/geo+json")),
  json: (river, core) =>
    finished(river, async () => text(river.network(await namesOf(river, core)), "application/json")),
  zip: packOf,
};

/** Takes a river, which nobody else has, to its end and makes a file of it. It is gone afterwards. */
export function fileOf(river: FullRiver, core: FileCore, format: Format): Promise<Blob> {
  return FORMATS[format](river, core);
}

/** All that games need, and the picture. */
async function packOf(river: FullRiver, core: FileCore): Promise<Blob> {
  const [contents, canvas] = await raised(river, async () => {
    const contents = contentsOf(river, await namesOf(river, core));
    return [contents, await drawn(river, core, LONG_SIDE_PX)] as const;
  });
  const picture = await (await encoded(canvas)).arrayBuffer();
  core.holdOn();
  return packed(contents, picture);
}

/** Makes something of a river and its relief, in a style that shows none too. */
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
