/** A river that is pointed at, in words. */

import { count } from "../../../browser/count.ts";
import type { PointedRiver } from "../../page-worker/protocol.ts";

/** So many rivers below are named one after the other; the rest is left out. */
const MOST_NAMED = 3;

/** What it is called. Most maps of one's own have rivers without a name. */
export function titleOf({ name }: PointedRiver): string {
  return name === "" ? "A river without a name" : name;
}

/** Its order, its length and what it drains. */
export function measuresOf({ order, orderHere, length, share, area }: PointedRiver): string {
  const here = orderHere === order ? "" : ` (${orderHere} here)`;
  const land = `drains ${percent(share)} of the land, ${count(roughly(area))} square units`;
  return `Order ${order}${here} · ${count(Math.round(length))} units long · ${land}`;
}

/** Where its water goes. */
export function courseOf({ into, endsIn }: PointedRiver): string {
  if (into.length === 0) return `Flows into the ${endsIn}`;
  const named = into.slice(0, MOST_NAMED).map(inSentence);
  const rest = into.length > MOST_NAMED ? ", and on to" : ", then";
  return `Flows into ${named.join(", then ")}${rest} the ${endsIn}`;
}

/** Some names have their article. */
function inSentence(name: string): string {
  return name === "" ? "a greater river" : `the ${name.replace(/^the /i, "")}`;
}

function percent(share: number): string {
  if (share < 0.01) return "less than 1 %";
  return `${Math.round(share * 100)} %`;
}

/** To two figures: what it is estimated from is no finer. */
function roughly(area: number): number {
  const step = 10 ** Math.max(0, Math.floor(Math.log10(Math.max(1, area))) - 1);
  return Math.round(area / step) * step;
}
