/** The way from the mouths to the finished map as one number. */

import type { Phase } from "../engine/types.ts";

/** The share of the way that is behind a river when it enters a phase, about as long as the phases are animated. */
const BEGINS: Record<Phase, number> = {
  growing: 0,
  drowning: 0.5,
  shaping: 0.65,
  meandering: 0.7,
  relief: 0.9,
  finished: 1,
};

const SHARES = Object.values(BEGINS);

/** Returns the share of the way, from 0 to 1, of a river in a phase of which a share is done. */
export function progressOf({ phase, progress }: { readonly phase: Phase; readonly progress: number }): number {
  const begin = BEGINS[phase];
  const end = SHARES[SHARES.indexOf(begin) + 1] ?? 1;
  return begin + (end - begin) * progress;
}
