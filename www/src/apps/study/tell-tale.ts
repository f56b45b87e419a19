/** Finds the measure that gives a grown piece away: the one that differs most from pieces of the world's rivers. */

import type { Measured } from "./piece.ts";

/** The words for a piece with more, and for one with less, of each measure. */
const WORDS: Record<keyof Measured, [more: string, less: string]> = {
  length: [
    "there was more river in it than in most of the world’s",
    "there was less river in it than in most of the world’s",
  ],
  confluences: ["its rivers met more often than real ones", "its rivers met less often than real ones"],
  ends: [
    "it had more short streams than the world’s maps show",
    "it had fewer short streams than the world’s maps show",
  ],
  straightness: ["its rivers ran straighter than real ones", "its rivers wound more than real ones"],
};

/** The number of standard deviations from which on a measure is mentioned. */
const TELLING = 1.25;

export function tellTale(measured: Measured, real: readonly Measured[]): string | undefined {
  const names = Object.keys(WORDS) as (keyof Measured)[];
  const offs = names.map((name) => ({
    name,
    off: offOf(
      measured[name],
      real.map((one) => one[name]),
    ),
  }));
  const { name, off } = offs.reduce((most, one) => (Math.abs(one.off) > Math.abs(most.off) ? one : most));
  if (!(Math.abs(off) > TELLING)) return;
  return WORDS[name][off > 0 ? 0 : 1];
}

/** Returns the deviation of a value from the mean of others, in standard deviations. */
function offOf(value: number, others: readonly number[]): number {
  const known = others.filter(Number.isFinite);
  const mean = known.reduce((sum, one) => sum + one, 0) / known.length;
  const spread = Math.sqrt(known.reduce((sum, one) => sum + (one - mean) ** 2, 0) / known.length);
  return Number.isFinite(value) && spread > 0 ? (value - mean) / spread : 0;
}
