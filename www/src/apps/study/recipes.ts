/**
 * The recipes that pieces are grown by: the six variants of the river paper, each over a range of its values, and
 * drainage.
 */

import type { Chance } from "../../browser/chance.ts";

/** The range of a value, both ends included, and the distance of its steps. */
export interface Range {
  least: number;
  most: number;
  step: number;
}

/** The values of the paper that are drawn by chance, by the names of their keys. Trim is in nodes, as in the paper. */
type Ranges = Partial<Record<"momentum" | "curl" | "stretch" | "trim", Range>>;

/** What shapes a way to grow. */
interface Way {
  /** Its name for readers, which follows “grown by”. */
  label: string;
  /** The values that it always has. */
  link: string;
  ranges: Ranges;
  /** The range of its number of attractors or parcels, by which the maps of a word differ. */
  attractors: Range;
}

/** k, θc, c and t of the paper. */
const K: Range = { least: 0.25, most: 0.55, step: 0.01 };
const THETA: Range = { least: 0.5, most: 1.2, step: 0.01 };
const C: Range = { least: 4, most: 12, step: 1 };
const T: Range = { least: 6, most: 20, step: 1 };

const FEW: Range = { least: 1500, most: 3000, step: 1 };
const MANY: Range = { least: 4000, most: 8000, step: 1 };

const variant = (label: string, preset: string, ranges: Ranges): Way => ({
  label: `space colonization${label}`,
  link: `preset=${preset}`,
  ranges,
  attractors: ranges.trim ? MANY : FEW,
});

export const RECIPES = {
  original: variant("", "original", {}),
  momentum: variant(" with momentum", "momentum", { momentum: K }),
  curl: variant(" with curl", "curl", { curl: THETA, stretch: C }),
  trimmed: variant(", trimmed", "trimmed-original", { trim: T }),
  trimmedMomentum: variant(" with momentum, trimmed", "trimmed-momentum", { momentum: K, trim: T }),
  trimmedCurl: variant(" with curl, trimmed", "trimmed-curl", { curl: THETA, stretch: C, trim: T }),
  drainage: {
    label: "drainage",
    link: "growth=drainage",
    ranges: {},
    attractors: { least: 15_000, most: 25_000, step: 1 },
  },
} as const satisfies Record<string, Way>;

export type RecipeName = keyof typeof RECIPES;

export const RECIPE_NAMES = Object.keys(RECIPES) as [RecipeName, ...RecipeName[]];

/** All land, so that no coast gives a map away, with mouths on all sides. */
const GROUND = "country=usual&land=rectangle&aspect=1&sides=nesw&edition=1";

/** Returns a link by a recipe, with values by chance. */
export function linkBy(name: RecipeName, seed: string, chance: Chance): string {
  const { link, ranges, attractors }: Way = RECIPES[name];
  const number = within(attractors, chance);
  const values = Object.entries(ranges).map(([key, range]) => {
    const value = within(range, chance);
    return `&${key}=${key === "trim" ? Math.round(value * nodeOf(number)) : value}`;
  });
  return `seed=${encodeURIComponent(seed)}&${GROUND}&${link}&attractors=${number}${values.join("")}`;
}

/** Returns the distance between nodes in units of a map of 1000 by 1000, from the number of attractors. */
function nodeOf(attractors: number): number {
  return (STEP * 1000) / Math.sqrt(attractors);
}

/** The step of the presets, in spacings of attractors. */
const STEP = 0.38;

function within({ least, most, step }: Range, chance: Chance): number {
  const value = least + step * chance(Math.round((most - least) / step) + 1);
  return Math.round(100 * value) / 100;
}
