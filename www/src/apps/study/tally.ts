/** Counts how often pieces passed for real. The counts are kept on the visitor's device and nowhere else. */

import { RECIPE_NAMES, type RecipeName } from "./recipes.ts";

/** Where a piece is from. */
export type Origin = "real" | RecipeName;

export const ORIGINS: readonly Origin[] = ["real", ...RECIPE_NAMES];

/** The numbers of pieces that were shown, and of those that were taken for real. */
export interface Counted {
  shown: number;
  passed: number;
}

export type Tally = Readonly<Record<Origin, Counted>>;

const KEPT = "riverseed study";

/** The largest number that is believed: nobody answers so often. */
const MOST = 1_000_000;

/** Reads the tally. Counts are zero if storage is not allowed or contains something else. */
export function tallyIn(storage: () => Storage): Tally {
  const kept = keptIn(storage);
  return Object.fromEntries(ORIGINS.map((origin) => [origin, countedIn(kept[origin])])) as Record<Origin, Counted>;
}

/** Counts an answer. */
export function count(origin: Origin, isTakenForReal: boolean, storage: () => Storage): void {
  const tally = tallyIn(storage);
  const { shown, passed } = tally[origin];
  if (shown === MOST) return;
  const counted = { shown: shown + 1, passed: passed + Number(isTakenForReal) };
  try {
    storage().setItem(KEPT, JSON.stringify({ ...tally, [origin]: counted }));
  } catch {
    // The next visit starts from what was kept before.
  }
}

export function forget(storage: () => Storage): void {
  try {
    storage().removeItem(KEPT);
  } catch {
    // What is not allowed to be kept need not be forgotten.
  }
}

/** Returns the number of all answers, and of those that were right. */
export function totalOf(tally: Tally): { asked: number; right: number } {
  const sum = (number: (origin: Origin, counted: Counted) => number): number =>
    ORIGINS.reduce((sum, origin) => sum + number(origin, tally[origin]), 0);
  return {
    asked: sum((_, { shown }) => shown),
    right: sum((origin, { shown, passed }) => (origin === "real" ? passed : shown - passed)),
  };
}

function keptIn(storage: () => Storage): Record<string, unknown> {
  try {
    const kept: unknown = JSON.parse(storage().getItem(KEPT) ?? "");
    if (typeof kept === "object" && kept !== null) return kept as Record<string, unknown>;
  } catch {
    // The same as nothing.
  }
  return {};
}

function countedIn(kept: unknown): Counted {
  const { shown, passed } = (kept ?? {}) as Record<string, unknown>;
  return isCount(shown) && isCount(passed) && passed <= shown ? { shown, passed } : { shown: 0, passed: 0 };
}

function isCount(value: unknown): value is number {
  return Number.isInteger(value) && (value as number) >= 0 && (value as number) <= MOST;
}
