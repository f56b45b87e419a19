/** Grows pieces of rivers for the study, each from another map. */

import { turn } from "../../browser/turn.ts";
import type { SteerCore } from "../../engine/steer.ts";
import { isWellCovered, type Piece, SIDE } from "./piece.ts";
import { thin } from "./thin.ts";

/** The recipe: white lines of one pixel on black, on a map that is all land, so that no coast gives it away. */
const RECIPE = "land=rectangle&aspect=1&sides=nesw&attractors=20000&channel-area=20&trim=60&style=skeleton&edition=1";

/** The range of a map's side in pixels. Pieces of such maps contain as much river as those of the world's maps. */
const SIDES = [210, 300] as const;

/** The number of pieces of a map that are tried before another map is grown. */
const TRIES = 30;

export interface Grown {
  seed: string;
  piece: Piece;
}

/** Grows maps in slices until one has a suitable piece. */
export async function grownPiece(core: SteerCore, chance: (below: number) => number): Promise<Grown> {
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

/** The longest time for which the page may not answer. */
const BUDGET_MS = 10;

/** Grows and paints a map, and returns its pixels: 1 where there is a river. */
async function drawn({ engine, memory }: SteerCore, link: string, side: number): Promise<Uint8Array> {
  const river = new engine.River(link);
  river.resize(side, side);
  await bitByBit(() => river.advance(1));
  await bitByBit(() => river.paint());
  const rgba = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
  // Rivers are light pixels.
  const pixels = Uint8Array.from({ length: side * side }, (_, at) => Number((rgba[4 * at] ?? 0) > 127));
  river.free();
  thin(pixels, side);
  return pixels;
}

/** Repeats a step until it returns false, and lets the page answer in between. */
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
