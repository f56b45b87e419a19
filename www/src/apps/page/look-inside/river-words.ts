/** Describes a river that is pointed at in words, or a lake along it. */

import { count } from "../../../browser/count.ts";
import type { PointedRiver } from "../../page-worker/protocol.ts";

/** The most rivers downstream that are named; the rest is left out. */
const MOST_NAMED = 3;

/** The water in which the way of a river's water ends, in words. */
const ENDS: Record<PointedRiver["endsIn"], string> = { sea: "the sea", lake: "the lake, which has no outlet" };

/** Returns the name of a river or lake, or a phrase if it has none. */
export function titleOf({ name, lake }: PointedRiver): string {
  if (lake) return lake.name === "" ? "A lake without a name" : lake.name;
  return name === "" ? "A river without a name" : name;
}

/** Describes a river's order, its length and the land it drains, or a lake's area, depth and height. */
export function measuresOf({ order, orderHere, length, share, area, lake }: PointedRiver): string {
  if (lake) {
    const [depth, level] = [lake.depth, lake.level].map((metres) => count(Math.max(1, Math.round(metres))));
    return `${figures(roughly(lake.area))} km² · up to ${depth} m deep · ${level} m above the sea`;
  }
  const here = orderHere === order ? "" : ` (${orderHere} here)`;
  const land = `drains ${percent(share)} of the land, ${figures(roughly(area))} km²`;
  return `Order ${order}${here} · ${figures(length)} km long · ${land}`;
}

/** Describes the way of its water to the sea. */
export function courseOf({ name, into, endsIn, mouths, lake }: PointedRiver): string {
  if (lake) return `${name === "" ? "A river" : `The ${name.replace(/^the /i, "")}`} runs out of it`;
  if (into.length === 0) return `Flows into ${ENDS[endsIn]}${mouths > 1 ? ` through ${mouths} mouths` : ""}`;
  const named = into.slice(0, MOST_NAMED).map(inSentence);
  const rest = into.length > MOST_NAMED ? ", and on to" : ", then";
  return `Flows into ${named.join(", then ")}${rest} ${ENDS[endsIn]}`;
}

/** Returns a name for the middle of a sentence. Some names have an article already. */
function inSentence(name: string): string {
  return name === "" ? "a greater river" : `the ${name.replace(/^the /i, "")}`;
}

function percent(share: number): string {
  if (share < 0.01) return "less than 1 %";
  return `${Math.round(share * 100)} %`;
}

/** Writes a number whole, and below ten with a decimal place, as the map writes kilometres. */
function figures(number: number): string {
  const tenths = Math.round(number * 10);
  return count(tenths < 100 ? tenths / 10 : Math.round(number));
}

/** Rounds to two figures, since the estimate is no finer. */
function roughly(area: number): number {
  const step = 10 ** Math.max(-1, Math.floor(Math.log10(Math.max(1, area))) - 1);
  return Math.round(area / step) * step;
}
