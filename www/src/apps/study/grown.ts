/** Grows pieces of rivers for the study, each from another map. */

import type { Chance } from "../../browser/chance.ts";
import { turn } from "../../browser/turn.ts";
import type { WholeCore } from "../../engine/whole.ts";
import { isWellCovered, lengthOf, type Piece, SIDE } from "./piece.ts";
import { linkBy, type RecipeName } from "./recipes.ts";
import { thin } from "./thin.ts";
import { isTreeLike } from "./trace.ts";

export interface Grown {
  by: RecipeName;
  seed: string;
  /** The link of the map that the piece is of. */
  link: string;
  piece: Piece;
}

/** What a piece is grown from. */
export interface Order {
  by: RecipeName;
  /** The number of river pixels that it should have, as the real ones: more or fewer would give it away. */
  length: number;
  seedOf: () => string;
  chance: Chance;
}

type River = InstanceType<WholeCore["engine"]["River"]>;

/** Lines of one pixel in a square: 1 where there is a river. */
interface Skeleton {
  side: number;
  pixels: Uint8Array;
}

/** The side at which a map is drawn first, and the range of its sides. The larger, the less river is in a piece. */
const FIRST_SIDE = 400;
const SIDES = [2 * SIDE, 9 * SIDE] as const;
/** The number of sides that are tried for a map. */
const SIDES_TRIED = 3;
/** The number of pieces of a map that are tried before another map is grown. */
const TRIES = 40;
/** The share by which the length of a piece may differ from the one ordered. */
const TOLERANCE = 0.12;

/** Grows maps in slices until one has a suitable piece. */
export async function grownPiece(core: WholeCore, { by, length, seedOf, chance }: Order): Promise<Grown> {
  for (;;) {
    const seed = seedOf();
    const link = linkBy(by, seed, chance);
    const river = new core.engine.River(`${link}&style=skeleton`);
    try {
      const piece = await pieceOf(core, river, length, chance);
      if (piece) return { by, seed, link, piece };
    } finally {
      river.free();
    }
  }
}

/** Looks for a piece of a map with as much river as it should have. */
async function pieceOf(core: WholeCore, river: River, length: number, chance: Chance): Promise<Piece | undefined> {
  const { side, pixels } = await drawn(core, river, length);
  for (let i = 0; i < TRIES; i++) {
    const piece = cut(pixels, side, chance(side - SIDE), chance(side - SIDE));
    const isAsLong = Math.abs(lengthOf(piece) / length - 1) < TOLERANCE;
    if (isAsLong && isWellCovered(piece) && isTreeLike(piece)) return piece;
  }
  return;
}

/** Grows a map and draws it at a side at which a piece has a length on average. */
async function drawn(core: WholeCore, river: River, length: number): Promise<Skeleton> {
  let side = FIRST_SIDE;
  for (let i = 0; ; i++) {
    const skeleton = await drawnAt(core, river, side);
    const average = skeleton.pixels.reduce((sum, is) => sum + is, 0) * (SIDE / side) ** 2;
    const better = Math.round(Math.min(SIDES[1], Math.max(SIDES[0], (side * average) / length)));
    if (i === SIDES_TRIED || Math.abs(better / side - 1) < TOLERANCE / 2) return skeleton;
    side = better;
  }
}

async function drawnAt({ memory }: WholeCore, river: River, side: number): Promise<Skeleton> {
  river.resize(side, side);
  await bitByBit(() => river.advance(1));
  await bitByBit(() => river.paint());
  const rgba = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
  // Rivers are light pixels.
  const pixels = Uint8Array.from({ length: side * side }, (_, at) => Number((rgba[4 * at] ?? 0) > 127));
  thin(pixels, side);
  return { side, pixels };
}

/** The longest time for which the page may not answer. */
const BUDGET_MS = 10;

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
