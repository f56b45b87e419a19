// Whole maps as people meet them, as wasm: from a link to a finished picture of 1024 x 640.

import { atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "A whole default map at 1024 x 640, from the link to the finished picture, in units of growing 100,000 attractors at R = 3":
    wholeMap,
};

async function* wholeMap({ wasm }) {
  const looks = [
    ["style=ink&labels=none", 2],
    ["style=atlas&labels=none", 4],
    ["style=atlas&labels=some", 4.5],
  ];
  for (const [look, bar] of looks) {
    const [drawn, unit] = await inTurn(9, [wasm, `map ${look}`], [wasm, "grow 100000 3"]);
    yield row(`wasm: ${look}`, median(ratios(drawn, unit)), "units", atMost(bar));
    yield guide("that is", median(drawn), "ms");
  }
}
