/** The neighbours of a map: maps of the same word and look, with one or two dials moved. */

import { type Chance, chanceOf, shuffled } from "../../../browser/chance.ts";
import type { Parameter } from "../../../engine/table.ts";
import { type Dial, dialsOf, type Values, type Varied } from "./dials.ts";

export interface Neighbour {
  /** The difference, in words: “more rivers, less winding”. */
  words: string;
  values: Values;
}

/** The number of neighbours around a map. */
export const AROUND = 8;
/** The most tries for each neighbour, of which few fail: where little can be moved, two may be the same. */
const TRIES = 8;
/** The number of steps from the least to the most that a dial is moved. */
const STEPS = 64;

/**
 * Returns the neighbours of a map, no two of which are equal; fewer than eight where little can be moved. They are the
 * same for the same map and round.
 */
export function neighboursOf(map: Varied, table: ReadonlyMap<string, Parameter>, round: number): Neighbour[] {
  const dials = dialsOf(map, table);
  // A map has the same neighbours in every style.
  const chance = chanceOf(JSON.stringify([...[...map.values].filter(([key]) => key !== "style"), round]));
  const sets = shuffled(setsOf(dials), chance);
  const found = new Map<string, Neighbour>();
  for (let turn = 0; sets.length > 0 && found.size < AROUND && turn < AROUND * TRIES; turn++) {
    const neighbour = moved(sets[turn % sets.length] ?? [], chance);
    const key = JSON.stringify(neighbour.values);
    if (neighbour.values.length > 0 && !found.has(key)) found.set(key, neighbour);
  }
  return [...found.values()];
}

/** Returns all pairs of dials, or a single one. */
function setsOf(dials: readonly Dial[]): (readonly Dial[])[] {
  if (dials.length < 2) return dials.map((dial) => [dial]);
  return dials.flatMap((one, i) => dials.slice(i + 1).map((other) => [one, other]));
}

function moved(dials: readonly Dial[], chance: Chance): Neighbour {
  const moves = dials.map((dial) => movedBy(dial, chance)).filter(({ values }) => values.length > 0);
  return { words: moves.map(({ words }) => words).join(", "), values: moves.flatMap(({ values }) => [...values]) };
}

/** Moves a dial up or down, and away from an end that is too near. */
function movedBy({ place, least, most, more, less, at }: Dial, chance: Chance): Neighbour {
  const by = least + (most - least) * (chance(STEPS + 1) / STEPS);
  const wish = chance(2) === 0 ? -by : by;
  const isOutside = place + wish < 0 || place + wish > 1;
  const goal = Math.min(1, Math.max(0, isOutside ? place - wish : place + wish));
  return { words: goal > place ? more : less, values: at(goal) };
}
