/** Pieces of rivers that are grown for the occasion, each of another map. */

import { turn } from "../../browser/turn.ts";
import type { FullCore } from "../../engine/full.ts";
import { isWellCovered, type Piece, SIDE } from "./piece.ts";
import { thin } from "./thin.ts";

/** White lines of one pixel on black, on a map that is all land: no coast tells it. */
const RECIPE = "land=rectangle&aspect=1&sides=nesw&attractors=20000&channel-area=20&trim=60&style=skeleton&edition=1";

/** Pixels of a map's side, from the least to the most: pieces of it have as much river as those of the world's maps. */
const SIDES = [210, 300] as const;

/** How many pieces of a map are tried before another is grown. */
const TRIES = 30;

export interface Grown {
  seed: string;
  piece: Piece;
}

/** Grows maps, a little at a time, until a piece of one will do. */
export async function grownPiece(core: FullCore, chance: (below: number) => number): Promise<Grown> {
  for (;;) {
    const seed = core.engine.freshSeed();
    const side = SIDES[0] + chance(SIDES[1] - SIDES[0]);
    const pixels = await drawn(core, `${RECIPE}&seed=${seed}`, side);
    for (let i = 0; i < TRIES; i++) {
      const piece = cut(pixels, side, chance(side - SIDE), chance(side - SIDE));
      if (isWellCovered(piece)) return { seed, piece };
    }
  }
}

/** How long the page may be kept from answering. */
const BUDGET_MS = 10;

/** Where a finished map has rivers. */
async function drawn({ engine, memory }: FullCore, link: string, side: number): Promise<Uint8Array> {
  const river = new engine.River(link);
  river.resize(side, side);
  await bitByBit(() => river.advance(1));
  await bitByBit(() => river.paint());
  const rgba = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
  // Rivers are light.
  const pixels = Uint8Array.from({ length: side * side }, (_, at) => Number((rgba[4 * at] ?? 0) > 127));
  river.free();
  thin(pixels, side);
  return pixels;
}

/** Does steps of a work, as long as one says that there is more to do. */
async function bitByBit(step: () => boolean): Promise<void> {
  let end = performance.now() + BUDGET_MS;
  while (step()) {
    if (performance.now() < end) continue;
    await turn();
    end = performance.now() + BUDGET_MS;
  }
}

function cut(pixels: Uint8Array, width: number, left: number, top: number): Piece {
  return Uint8Array.from({ length: SIDE * SIDE }, (_, at) => {
    const pixel = (top + Math.floor(at / SIDE)) * width + left + (at % SIDE);
    return pixels[pixel] ?? 0;
  });
}
