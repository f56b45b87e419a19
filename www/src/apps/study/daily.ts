/** The five pieces of a day, which follow from its date and are the same for everybody, and the line that tells how it went. */

import { chanceOf, oneOf } from "../../browser/chance.ts";
import type { Order } from "./grown.ts";
import { RECIPE_NAMES } from "./recipes.ts";

export const FIVE = 5;

/** What a reader can say of a piece, and what a piece can be. */
export type Is = "real" | "grown";

/** A piece, as it is chosen: the place of a real one, or what another is grown from. */
export type Dealt = { is: "real"; place: number } | { is: "grown"; order: Order };

/** Returns the date in UTC, so that a day begins for everybody at once. */
export function today(now = new Date()): string {
  return now.toISOString().slice(0, 10);
}

/** Deals the pieces of a date, each real or grown with equal chances. `lengths` are those of all real pieces. */
export function dealOf(date: string, lengths: readonly number[]): Dealt[] {
  const chance = chanceOf(`riverseed ${date}`);
  const left = [...lengths.keys()];
  return Array.from({ length: FIVE }, (_, i): Dealt => {
    const [place = 0] = left.splice(chance(left.length), 1);
    if (chance(2) === 1) return { is: "real", place };
    // Of its own, since it depends on maps how much chance a piece takes to grow.
    const own = chanceOf(`riverseed ${date} ${i}`);
    const order = {
      by: oneOf(RECIPE_NAMES, own),
      length: lengths[place] ?? 0,
      seedOf: () => oneOf(SEEDS, own),
      chance: own,
    };
    return { is: "grown", order };
  });
}

/** The words that pieces of a day are grown from. */
const SEEDS = (
  "alder amber anchor aspen barley basin birch bramble brook cedar chalk clover cove crane curlew delta dipper dune " +
  "eddy egret elm ember estuary fern finch flint gorge granite gravel gull harbour hazel heron island juniper " +
  "kestrel kingfisher lagoon larch lichen lynx marsh meadow mist moor moss newt oak osprey otter oxbow pebble perch " +
  "pike pine plover reed ridge rowan rush salmon sedge shale shoal silt sorrel spring spruce stone stork swan tarn " +
  "teal thistle tide trout vale wader warbler weir willow wren yarrow"
).split(" ") as [string, ...string[]];

const KEPT = "riverseed daily five";

/** Reads what has been said of the pieces of a date. */
export function saidOn(date: string, storage: () => Storage): Is[] {
  try {
    const [on, said = ""] = storage().getItem(KEPT)?.split(" ") ?? [];
    if (on === date && /^[rg]{0,5}$/.test(said)) return [...said].map((one) => (one === "r" ? "real" : "grown"));
  } catch {
    // The same as nothing.
  }
  return [];
}

export function keepSaid(date: string, said: readonly Is[], storage: () => Storage): void {
  try {
    storage().setItem(KEPT, `${date} ${said.map((one) => one[0]).join("")}`);
  } catch {
    // It can be played again.
  }
}

/** Returns the line of a result, which does not tell which pieces were real. */
export function resultLine(date: string, isRight: readonly boolean[], address: string): string {
  const marks = isRight.map((is) => (is ? "●" : "○")).join("");
  return `Riverseed, real or grown, ${date}: ${marks} ${isRight.filter(Boolean).length}/${isRight.length} ${address}`;
}
