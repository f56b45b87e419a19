// From a tree to rivers, and their bends beside those of nature.

import { atLeast, atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "Rivers of a default map, and their rounds of meandering": rivers,
  "Bends of the great rivers of 20 maps; in nature wavelength 11 widths, radius 2 to 3": bends,
  "Rivers of twelve words on the usual land; medians beside nature's ranges": nature,
};

/** What is asked of measures for which nature's figures are not known. */
const ASKED = { hooks: 0.12, beside: 0.07 };

/** The measures of which nature's range is known. */
const KNOWN =
  `bifurcation-ratio length-ratio tokunaga-t1 tokunaga-c hack-exponent area-exponent sinuosity junction-spacing nearest-line
  turn-kurtosis turn-autocorrelation gap-variation anisotropy`.split(/\s+/);

async function* rivers({ native, wasm }) {
  const MANY = 30; // maps side by side, of 10,000 vertices each
  for (const side of [native, wasm]) {
    const [round, pairs] = await inTurn(5, [side, "round 1", 9], [side, "pairs"]);
    yield row(`${side.name}: all pairs / a round over 10,000 vertices`, median(ratios(pairs, round)), "×", atLeast(20));
    yield guide("a round", median(round), "ms");
  }
  const [natively, asWasm] = await inTurn(9, [native, "round 1", 9], [wasm, "round 1", 9]);
  yield row("a round: wasm / native", median(ratios(asWasm, natively)), "×", atMost(1.35));
  for (const side of [native, wasm]) {
    const [few, many] = await inTurn(5, [side, "round 1", 9], [side, `round ${MANY}`, 3]);
    const exponent = median(ratios(many, few).map((ratio) => Math.log10(ratio) / Math.log10(MANY)));
    yield row(`${side.name}: exponent from 10,000 to 300,000 vertices`, exponent, "", atMost(1.1));
  }
  const [nativeShape, wasmShape] = await inTurn(9, [native, "shape", 3], [wasm, "shape", 3]);
  yield row("wasm: the whole network stage of a default map", median(wasmShape), "ms", atMost(50));
  yield guide("native", median(nativeShape), "ms");
  for (const [task, what] of [
    ["late simplify 60 62", "simplify"],
    ["late width 14 14.5", "width"],
    ["late style ink dark", "style"],
  ]) {
    const [late] = await inTurn(9, [wasm, task, 4]);
    yield row(`wasm, ${what} changes: until the finished picture at 1024²`, median(late), "ms", atMost(16));
  }
}

async function* bends({ native }) {
  for (const model of ["bend", "flow"]) {
    for (const [measure, unit] of [
      ["wavelength", "widths"],
      ["radius", "widths"],
      ["sinuosity", ""],
    ]) {
      const quartiles = [];
      for (const percent of [25, 50, 75]) {
        quartiles.push((await native.run(`bends ${model} ${measure} ${percent}`)).result / 100);
      }
      yield guide(`${model}: ${measure}, quartiles ${quartiles.join(", ")}; median`, quartiles[1], unit);
    }
  }
}

async function* nature({ native }) {
  const figure = async (measure, which) => ((await native.run(`nature ${measure} ${which}`)).result | 0) / 10_000;
  for (const [measure, most] of Object.entries(ASKED)) {
    yield row(measure, await figure(measure, "median"), "", atMost(Number((1.25 * most).toFixed(4)), most));
  }
  for (const measure of KNOWN) {
    const values = [];
    for (const which of ["median", "least", "most"]) values.push(await figure(measure, which));
    yield guide(`${measure}, in nature ${values[1]} to ${values[2]}`, values[0], "");
  }
}
