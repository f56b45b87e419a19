/** Says what pieces were, for readers. */

import { count } from "../../browser/count.ts";
import { el } from "../../browser/dom.ts";
import { SHOWN } from "./drawing.ts";
import type { Shown } from "./game.ts";
import { RECIPES } from "./recipes.ts";
import type { Origin } from "./tally.ts";

/** Says where a piece is from: “real, near the Danube, 600 km across”. */
export function toldOf(shown: Shown): (Node | string)[] {
  if (shown.is === "grown") return ["grown from ", mapOf(shown.seed, shown.link), ` by ${RECIPES[shown.by].label}`];
  const place = shown.river === "" ? "" : `, near the ${shown.river}`;
  return [`real${place}, ${count(Math.round(shown.kilometresPerPixel * SHOWN))} km across`];
}

/** Returns the name of an origin, for a table. */
export function nameOf(origin: Origin): string {
  if (origin === "real") return "Real rivers";
  const { label } = RECIPES[origin];
  return `${label[0]?.toUpperCase()}${label.slice(1)}`;
}

/** Returns a link to the map that a piece was cut from. */
function mapOf(seed: string, link: string): HTMLElement {
  return el("a", { href: `./?${link}` }, seed);
}
