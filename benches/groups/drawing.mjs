// Drawing, and what a slider of growth makes of it.

import { atLeast, atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "Drawing 100,000 segments at 1024²": drawing,
  "A slider or a pen moves: regrow and redraw 15,000 attractors at 1024²": slider,
};

async function* drawing({ native, wasm }) {
  const ways = { "mask-ribbons": "ribbons filled into a mask", ribbons: "ribbons filled", strokes: "strokes" };
  for (const side of [native, wasm]) {
    const [ours, ...theirs] = await inTurn(7, ...["capsules", ...Object.keys(ways)].map((task) => [side, task]));
    const best = theirs.reduce((best, times) => (median(times) < median(best) ? times : best));
    yield row(`${side.name}: tiny-skia's best way / capsules`, median(ratios(best, ours)), "×", atLeast(8, 14));
    yield guide("capsules into a mask", median(ours), "ms");
    for (const [i, way] of Object.values(ways).entries()) yield guide(`tiny-skia, ${way}`, median(theirs[i]), "ms");
    const [picture] = await inTurn(7, [side, "picture"]);
    yield guide("the whole finished picture", median(picture), "ms");
  }
  for (const side of [native, wasm]) {
    const { result } = await side.run("differing");
    yield row(`${side.name}: bytes that differ, painted in 8-tick frames or at once`, result, "", atMost(0));
  }
}

async function* slider({ native, wasm }) {
  for (const [what, task] of [
    ["R = 3", "slider 15000"],
    ["space colonization at the table's reach and kill", "page-slider 15000"],
    ["space colonization of 6,000 attractors on a drawn land whose roughness changes", "pen"],
  ]) {
    // Moved, a slider asks for one picture right after the other.
    const [natively, asWasm] = await inTurn(9, [native, task, 5], [wasm, task, 5]);
    yield row(`wasm, ${what}`, median(asWasm), "ms", atMost(16, 10));
    yield guide("native", median(natively), "ms");
  }
}
