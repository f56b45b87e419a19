/** Finished rivers in every format that the page offers. A module of its own: widgets need not load what writes archives. */

import type { FullCore, FullRiver } from "../engine/full.ts";
import { drawn, encoded, finished, inSlices, LONG_SIDE_PX, pngOf, svgOf } from "./files.ts";
import { contentsOf, packed } from "./game-pack.ts";

const FORMATS = {
  png: (river: FullRiver, { memory }: FullCore) => pngOf(river, memory, LONG_SIDE_PX),
  svg: svgOf,
  geojson: (river: FullRiver) => raised(river, () => text(river.geojson(), "application/geo+json")),
  json: (river: FullRiver) => finished(river, () => text(river.network(), "application/json")),
  zip: packOf,
};

/** The formats, each named as its files end. */
export type Format = keyof typeof FORMATS;

export function isFormat(name: string | undefined): name is Format {
  return name !== undefined && Object.hasOwn(FORMATS, name);
}

/** Takes a river, which nobody else has, to its end and makes a file of it. It is gone afterwards. */
export function fileOf(river: FullRiver, core: FullCore, format: Format): Promise<Blob> {
  return FORMATS[format](river, core);
}

/** All that games need, and the picture. */
async function packOf(river: FullRiver, { memory }: FullCore): Promise<Blob> {
  const [contents, canvas] = await raised(
    river,
    () => [contentsOf(river), drawn(river, memory, LONG_SIDE_PX)] as const,
  );
  return packed(contents, await (await encoded(canvas)).arrayBuffer());
}

/** Makes something of a river and its relief, in a style that shows none too. */
function raised<Made>(river: FullRiver, make: () => Made | Promise<Made>): Promise<Made> {
  return finished(river, async () => {
    await inSlices(() => river.raiseRelief());
    return make();
  });
}

function text(value: object, type: string): Blob {
  return new Blob([JSON.stringify(value)], { type });
}
