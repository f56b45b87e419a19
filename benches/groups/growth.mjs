// Growth: against the twin, between the sides, with numbers, on lands, and its two other ways.

import { wasmSide } from "../sides.mjs";
import { atLeast, atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "Growth equals the brute-force twin, bit for bit (400 attractors, 6 presets, 20 seeds each)": equality,
  "Growth against the twin, the paper as written by the same compiler": againstTwin,
  "Growth, wasm against native": wasmAgainstNative,
  "Growth from 10,000 to 1,000,000 attractors, R = 3": scaling,
  "Growth on land, against growth on the plain rectangle, a node each (100,000 attractors, R = 3)": onLand,
  "Brownian tree on 1024² cells, sensitivity 12": brownian,
  "Drainage from the recipe to its last round, and to the finished picture of an island at 1024²": drainage,
};

async function* equality({ native, wasm }) {
  for (const side of [native, wasm]) {
    const { result } = await side.run("variants");
    yield row(`${side.name}: equal trees`, result, "", atLeast(120));
  }
}

async function* againstTwin({ native }) {
  const [fast] = await inTurn(15, [native, "grow 10000 3"]);
  const twin = await native.run("twin 10000 3");
  yield row("native, N = 10,000, R = 3: twin / ours", twin.ms / median(fast), "×", atLeast(1500, 2500));
  yield guide("ours", median(fast), "ms");
  yield guide("the twin, once", twin.ms, "ms");
}

async function* wasmAgainstNative({ native, wasm }) {
  for (const [reach, bar] of [
    [3, atMost(1.25, 1.1)],
    [10, atMost(1.35, 1.2)],
  ]) {
    const task = `grow 100000 ${reach}`;
    const [natively, asWasm] = await inTurn(15, [native, task], [wasm, task]);
    yield row(`N = 100,000, R = ${reach}: wasm / native`, median(ratios(asWasm, natively)), "×", bar);
    yield guide("native", median(natively), "ms");
    yield guide("wasm", median(asWasm), "ms");
  }
}

async function* scaling({ native, wasm }) {
  const sides = [native, wasm];
  const works = sides.flatMap((side) => [
    // A hundred times as short, so taken several times.
    [side, "grow 10000 3", 9],
    [side, "grow 1000000 3"],
  ]);
  const times = await inTurn(5, ...works);
  for (const [i, side] of sides.entries()) {
    const [few, many] = times.slice(2 * i);
    const exponent = median(ratios(many, few).map((ratio) => Math.log10(ratio) / 2));
    yield row(`${side.name}: exponent`, exponent, "", atMost(1.06, 1.03));
    yield guide("N = 10,000", median(few), "ms");
    yield guide("N = 1,000,000", median(many), "ms");
  }
  const fresh = wasmSide();
  await fresh.run("grow 1000000 3");
  yield row("wasm memory, N = 1,000,000", fresh.memory() / 1e6, "MB", atMost(180, 110));
}

async function* onLand({ native, wasm }) {
  const figures = ["crescent", "twins", "long", "arms", "gulf"];
  const kinds = ["rectangle", "continent", "island", "archipelago", "valley", "basin", ...figures, "drawn"];
  for (const side of [native, wasm]) {
    const nodes = {};
    for (const kind of kinds) nodes[kind] = (await side.run(`grow-on ${kind} 100000`)).result;
    const [plain, ...others] = await inTurn(9, ...kinds.map((kind) => [side, `grow-on ${kind} 100000`]));
    for (const [i, kind] of kinds.slice(1).entries()) {
      const cost = median(ratios(others[i], plain)) * (nodes.rectangle / nodes[kind]);
      yield row(`${side.name}: ${kind} / rectangle`, cost, "×", atMost(1.2));
    }
    const [shaping] = await inTurn(9, [side, "land continent"]);
    yield guide("shaping a continent", median(shaping), "ms");
  }
}

async function* brownian({ native, wasm }) {
  const [natively, asWasm] = await inTurn(9, [native, "brownian 1024 12"], [wasm, "brownian 1024 12"]);
  const literal = await native.run("literal-brownian 1024 12");
  yield row("native: a literal search / ours", literal.ms / median(natively), "×", atLeast(6, 10));
  yield guide("ours", median(natively), "ms");
  yield guide("a literal search, once", literal.ms, "ms");
  yield row("wasm / native", median(ratios(asWasm, natively)), "×", atMost(1.35, 1.2));
  yield guide("wasm", median(asWasm), "ms");
}

async function* drainage({ native, wasm }) {
  const [few, many] = [6_000, 100_000];
  const sides = [native, wasm];
  const times = await inTurn(
    5,
    ...sides.flatMap((side) => [
      [side, `drain ${few}`, 5],
      [side, `drain ${many}`],
    ]),
  );
  for (const [i, side] of sides.entries()) {
    const [short, long] = times.slice(2 * i);
    const exponent = Math.log(median(ratios(long, short))) / Math.log(many / few);
    yield row(`${side.name}: exponent from 6,000 to 100,000 parcels`, exponent, "", atMost(1.1));
  }
  const [, nativeLong, wasmShort, wasmLong] = times;
  yield row("wasm: 6,000 parcels", median(wasmShort), "ms", atMost(25));
  yield row("wasm: 100,000 parcels", median(wasmLong), "ms", atMost(600));
  yield guide("100,000 parcels: wasm / native", median(ratios(wasmLong, nativeLong)), "×");
  const growths = ["drainage", "colonize"];
  const [drained, colonized] = await inTurn(7, ...growths.map((growth) => [wasm, `finish ${growth} ${few}`, 3]));
  yield row("wasm: from a link to the finished picture, 6,000 parcels", median(drained), "ms", atMost(60));
  yield guide("that of drainage / of space colonization", median(ratios(drained, colonized)), "×");
  const [whole] = await inTurn(5, [wasm, "finish drainage 20000"]);
  yield guide("wasm: with 20,000 parcels, the table's default", median(whole), "ms");
}
