// The relief of finished rivers, in styles and on finer grids.

import { atMost, guide, row } from "../table.mjs";
import { inTurn, less, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "The relief of a default map, and other styles at 1024² when it is there": relief,
  "The relief of a rectangle on finer grids, natively": grids,
};

async function* relief({ native, wasm }) {
  const [natively, asWasm] = await inTurn(9, [native, "relief"], [wasm, "relief"]);
  // From a link to the picture: 250 ms with a relief, of two solutions of all cells, and 60 without.
  yield row("wasm: the relief of a finished network", median(asWasm), "ms", atMost(190));
  yield guide("native", median(natively), "ms");
  const quick = ["atlas", "night", "survey", "basins"].map((style) => [style, 25]);
  const slow = ["parchment", "past-courses", "ink-wash", "orbit", "blueprint"].map((style) => [style, 150]);
  for (const land of ["island", "rectangle"]) {
    const atlas = `restyle ${land} atlas`;
    for (const [style, bar] of [...quick, ...slow]) {
      const tasks = [`restyle ${land} ${style}`, `restyle-less-painting ${land} ${style}`];
      const [natively, copied, asWasm, copiedAsWasm] = await inTurn(
        9,
        ...[native, wasm].flatMap((side) => tasks.map((task) => [side, task, 3])),
      );
      yield row(`wasm, ${land}: another style, now ${style}`, median(less(asWasm, copiedAsWasm)), "ms", atMost(bar));
      yield guide("native", median(less(natively, copied)), "ms");
    }
    // Everything else is as for a change to Atlas.
    const [shaded, styled] = await inTurn(9, [wasm, `reshade ${land}`, 3], [wasm, atlas, 3]);
    yield row(`wasm, ${land}: shading`, median(less(shaded, styled)), "ms", atMost(10));
  }
}

async function* grids({ native }) {
  const [small, large] = await inTurn(5, [native, "grid 1024 1"], [native, "grid 4096 1"]);
  yield row("µs a cell, 4096 x 2560", (median(large) * 1000) / (4096 * 2560), "µs", atMost(0.5));
  yield row("exponent from 1024 x 640 on", Math.log(median(ratios(large, small))) / Math.log(16), "", atMost(1.05));
  const passed = async (threads) => {
    const begun = performance.now();
    await native.run(`grid 4096 ${threads}`);
    return performance.now() - begun;
  };
  const [one, two] = [await passed(1), await passed(2)];
  yield guide("time that passes on two threads / on one", two / one, "×");
}
