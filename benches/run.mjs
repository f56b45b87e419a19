#!/usr/bin/env node
// Prints the project's figures, each beside its floor and its aim: natively, as wasm in Node, and in the page.
//
//   make bench                    everything
//   node benches/run.mjs WORD…    only groups whose names contain a word; scripts/wasm.mjs figures must have run
//
// The machine may be busy, so times are those that a process spent on a processor, where that can be known (native: on
// Linux). What is compared runs in turn, ratios are taken within a turn, and their median counts.

import { execFileSync, spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));

const GROUPS = {
  "Growth equals the brute-force twin, bit for bit (400 attractors, 6 presets, 20 seeds each)": equality,
  "Growth against the twin, the paper as written by the same compiler": againstTwin,
  "Growth, wasm against native": wasmAgainstNative,
  "Growth from 10,000 to 1,000,000 attractors, R = 3": scaling,
  "Growth on land, against growth on the plain rectangle, a node each (100,000 attractors, R = 3)": onLand,
  "Brownian tree on 1024² cells, sensitivity 12": brownian,
  "Drainage from the recipe to its last round, and to the finished picture of an island at 1024²": drainage,
  "Drawing 100,000 segments at 1024²": drawing,
  "A slider or a pen moves: regrow and redraw 15,000 attractors at 1024²": slider,
  "Rivers of a default map, and their rounds of meandering": rivers,
  "The relief of a default map, and other styles at 1024² when it is there": relief,
  "A whole default map at 1024 x 640, from the link to the finished picture, in units of growing 100,000 attractors at R = 3": wholeMap,
  "The relief of a rectangle on finer grids, natively": grids,
  "Labels of a map at 1024², from the link to the finished picture": labels,
  "Woods and hills of a map at 1024², from the link to the finished picture": woods,
  "Bends of the great rivers of 20 maps; in nature wavelength 11 widths, radius 2 to 3": bends,
  "Rivers of twelve words on the usual land; medians beside nature's ranges": nature,
  "Whole maps with their files, natively: islands of which nothing is trimmed, with their relief": whole,
  "A picture of 2048² as PNG, natively": png,
  "The page at 1024², while 100,000 attractors grow, then while the rivers of 6,000 meander": page,
  "A slider of the page moves: from its event to other pixels of a map of 20,000, in a window of 1440 by 900": sliders,
  "The page by Lighthouse's performance, a phone and a desktop, medians of five": lighthouse,
  "A widget in a post, grown in a worker, then on the page itself": widget,
  "The wasm file of the page": size,
};

/** What a measured number has to be, and what it ought to be. */
const atLeast = (floor, aim = floor) => ({ floor, aim, meets: (value, bar) => value >= bar });
const atMost = (floor, aim = floor) => ({ floor, aim, meets: (value, bar) => value <= bar });

/** What is asked of measures for which nature's figures are not known. */
const ASKED = { hooks: 0.12, beside: 0.07 };

/** The measures of which nature's range is known. */
const KNOWN = `bifurcation-ratio length-ratio tokunaga-t1 tokunaga-c hack-exponent area-exponent sinuosity junction-spacing nearest-line
  turn-kurtosis turn-autocorrelation gap-variation anisotropy`.split(/\s+/);

const missed = [];
const native = await nativeSide();
const wasm = wasmSide();
try {
  const words = process.argv.slice(2).map((word) => word.toLowerCase());
  console.log("N uniform attractors, one mouth, reach R spacings, kill and step ½ spacing, no trimming; growth is timed");
  console.log("from the recipe to the last node. Processor time, medians.");
  for (const [name, measure] of Object.entries(GROUPS)) {
    if (words.length > 0 && !words.some((word) => name.toLowerCase().includes(word))) continue;
    print(`\n${name}`, "measured", "floor", "aim");
    await measure();
  }
} finally {
  native.close();
}
console.log(missed.length === 0 ? "\nAll floors are met." : `\nMISSED ${missed.length}: ${missed.join("; ")}`);

// ---- the groups

async function equality() {
  for (const side of [native, wasm]) {
    const { result } = await side.run("variants");
    row(`${side.name}: equal trees`, result, "", atLeast(120));
  }
}

async function againstTwin() {
  const [fast] = await inTurn(15, [native, "grow 10000 3"]);
  const twin = await native.run("twin 10000 3");
  row("native, N = 10,000, R = 3: twin / ours", twin.ms / median(fast), "×", atLeast(1500, 2500));
  guide("ours", median(fast), "ms");
  guide("the twin, once", twin.ms, "ms");
}

async function wasmAgainstNative() {
  for (const [reach, bar] of [
    [3, atMost(1.25, 1.1)],
    [10, atMost(1.35, 1.2)],
  ]) {
    const task = `grow 100000 ${reach}`;
    const [natively, asWasm] = await inTurn(15, [native, task], [wasm, task]);
    row(`N = 100,000, R = ${reach}: wasm / native`, median(ratios(asWasm, natively)), "×", bar);
    guide("native", median(natively), "ms");
    guide("wasm", median(asWasm), "ms");
  }
}

async function scaling() {
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
    row(`${side.name}: exponent`, exponent, "", atMost(1.06, 1.03));
    guide("N = 10,000", median(few), "ms");
    guide("N = 1,000,000", median(many), "ms");
  }
  const fresh = wasmSide();
  await fresh.run("grow 1000000 3");
  row("wasm memory, N = 1,000,000", fresh.memory() / 1e6, "MB", atMost(180, 110));
}

async function onLand() {
  const figures = ["crescent", "twins", "long", "arms", "gulf"];
  const kinds = ["rectangle", "continent", "island", "archipelago", "valley", "basin", ...figures, "drawn"];
  for (const side of [native, wasm]) {
    const nodes = {};
    for (const kind of kinds) nodes[kind] = (await side.run(`grow-on ${kind} 100000`)).result;
    const [plain, ...others] = await inTurn(9, ...kinds.map((kind) => [side, `grow-on ${kind} 100000`]));
    for (const [i, kind] of kinds.slice(1).entries()) {
      const cost = median(ratios(others[i], plain)) * (nodes.rectangle / nodes[kind]);
      row(`${side.name}: ${kind} / rectangle`, cost, "×", atMost(1.2));
    }
    const [shaping] = await inTurn(9, [side, "land continent"]);
    guide("shaping a continent", median(shaping), "ms");
  }
}

async function brownian() {
  const [natively, asWasm] = await inTurn(9, [native, "brownian 1024 12"], [wasm, "brownian 1024 12"]);
  const literal = await native.run("literal-brownian 1024 12");
  row("native: a literal search / ours", literal.ms / median(natively), "×", atLeast(6, 10));
  guide("ours", median(natively), "ms");
  guide("a literal search, once", literal.ms, "ms");
  row("wasm / native", median(ratios(asWasm, natively)), "×", atMost(1.35, 1.2));
  guide("wasm", median(asWasm), "ms");
}

async function drainage() {
  const [few, many] = [6_000, 100_000];
  const sides = [native, wasm];
  const times = await inTurn(5, ...sides.flatMap((side) => [[side, `drain ${few}`, 5], [side, `drain ${many}`]]));
  for (const [i, side] of sides.entries()) {
    const [short, long] = times.slice(2 * i);
    const exponent = Math.log(median(ratios(long, short))) / Math.log(many / few);
    row(`${side.name}: exponent from 6,000 to 100,000 parcels`, exponent, "", atMost(1.1));
  }
  const [, nativeLong, wasmShort, wasmLong] = times;
  row("wasm: 6,000 parcels", median(wasmShort), "ms", atMost(25));
  row("wasm: 100,000 parcels", median(wasmLong), "ms", atMost(600));
  guide("100,000 parcels: wasm / native", median(ratios(wasmLong, nativeLong)), "×");
  const growths = ["drainage", "colonize"];
  const [drained, colonized] = await inTurn(7, ...growths.map((growth) => [wasm, `finish ${growth} ${few}`, 3]));
  row("wasm: from a link to the finished picture, 6,000 parcels", median(drained), "ms", atMost(60));
  guide("that of drainage / of space colonization", median(ratios(drained, colonized)), "×");
  const [whole] = await inTurn(5, [wasm, "finish drainage 20000"]);
  guide("wasm: with 20,000 parcels, the table's default", median(whole), "ms");
}

async function drawing() {
  const ways = { "mask-ribbons": "ribbons filled into a mask", ribbons: "ribbons filled", strokes: "strokes" };
  for (const side of [native, wasm]) {
    const [ours, ...theirs] = await inTurn(7, ...["capsules", ...Object.keys(ways)].map((task) => [side, task]));
    const best = theirs.reduce((best, times) => (median(times) < median(best) ? times : best));
    row(`${side.name}: tiny-skia's best way / capsules`, median(ratios(best, ours)), "×", atLeast(8, 14));
    guide("capsules into a mask", median(ours), "ms");
    for (const [i, way] of Object.values(ways).entries()) guide(`tiny-skia, ${way}`, median(theirs[i]), "ms");
    const [picture] = await inTurn(7, [side, "picture"]);
    guide("the whole finished picture", median(picture), "ms");
  }
  for (const side of [native, wasm]) {
    const { result } = await side.run("differing");
    row(`${side.name}: bytes that differ, painted in 8-tick frames or at once`, result, "", atMost(0));
  }
}

async function slider() {
  for (const [what, task] of [
    ["R = 3", "slider 15000"],
    ["space colonization at the table's reach and kill", "page-slider 15000"],
    ["space colonization of 6,000 attractors on a drawn land whose roughness changes", "pen"],
  ]) {
    // Moved, a slider asks for one picture right after the other.
    const [natively, asWasm] = await inTurn(9, [native, task, 5], [wasm, task, 5]);
    row(`wasm, ${what}`, median(asWasm), "ms", atMost(16, 10));
    guide("native", median(natively), "ms");
  }
}

async function bends() {
  for (const model of ["bend", "flow"]) {
    for (const [measure, unit] of [["wavelength", "widths"], ["radius", "widths"], ["sinuosity", ""]]) {
      const quartiles = [];
      for (const percent of [25, 50, 75]) {
        quartiles.push((await native.run(`bends ${model} ${measure} ${percent}`)).result / 100);
      }
      guide(`${model}: ${measure}, quartiles ${quartiles.join(", ")}; median`, quartiles[1], unit);
    }
  }
}

async function nature() {
  const figure = async (measure, which) => ((await native.run(`nature ${measure} ${which}`)).result | 0) / 10_000;
  for (const [measure, most] of Object.entries(ASKED)) {
    row(measure, await figure(measure, "median"), "", atMost(Number((1.25 * most).toFixed(4)), most));
  }
  for (const measure of KNOWN) {
    const values = [];
    for (const which of ["median", "least", "most"]) values.push(await figure(measure, which));
    guide(`${measure}, in nature ${values[1]} to ${values[2]}`, values[0], "");
  }
}

async function rivers() {
  const MANY = 30; // maps side by side, of 10,000 vertices each
  for (const side of [native, wasm]) {
    const [round, pairs] = await inTurn(5, [side, "round 1", 9], [side, "pairs"]);
    row(`${side.name}: all pairs / a round over 10,000 vertices`, median(ratios(pairs, round)), "×", atLeast(20));
    guide("a round", median(round), "ms");
  }
  const [natively, asWasm] = await inTurn(9, [native, "round 1", 9], [wasm, "round 1", 9]);
  row("a round: wasm / native", median(ratios(asWasm, natively)), "×", atMost(1.35));
  for (const side of [native, wasm]) {
    const [few, many] = await inTurn(5, [side, "round 1", 9], [side, `round ${MANY}`, 3]);
    const exponent = median(ratios(many, few).map((ratio) => Math.log10(ratio) / Math.log10(MANY)));
    row(`${side.name}: exponent from 10,000 to 300,000 vertices`, exponent, "", atMost(1.1));
  }
  const [nativeShape, wasmShape] = await inTurn(9, [native, "shape", 3], [wasm, "shape", 3]);
  row("wasm: the whole network stage of a default map", median(wasmShape), "ms", atMost(50));
  guide("native", median(nativeShape), "ms");
  for (const [task, what] of [
    ["late simplify 60 62", "simplify"],
    ["late width 14 14.5", "width"],
    ["late style ink dark", "style"],
  ]) {
    const [late] = await inTurn(9, [wasm, task, 4]);
    row(`wasm, ${what} changes: until the finished picture at 1024²`, median(late), "ms", atMost(16));
  }
}

async function relief() {
  const [natively, asWasm] = await inTurn(9, [native, "relief"], [wasm, "relief"]);
  // From a link to the picture: 250 ms with a relief, of two solutions of all cells, and 60 without.
  row("wasm: the relief of a finished network", median(asWasm), "ms", atMost(190));
  guide("native", median(natively), "ms");
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
      row(`wasm, ${land}: another style, now ${style}`, median(less(asWasm, copiedAsWasm)), "ms", atMost(bar));
      guide("native", median(less(natively, copied)), "ms");
    }
    // Everything else is as for a change to Atlas.
    const [shaded, styled] = await inTurn(9, [wasm, `reshade ${land}`, 3], [wasm, atlas, 3]);
    row(`wasm, ${land}: shading`, median(less(shaded, styled)), "ms", atMost(10));
  }
}

async function wholeMap() {
  const looks = [
    ["style=ink&labels=none", 2],
    ["style=atlas&labels=none", 4],
    ["style=atlas&labels=some", 4.5],
  ];
  for (const [look, bar] of looks) {
    const [drawn, unit] = await inTurn(9, [wasm, `map ${look}`], [wasm, "grow 100000 3"]);
    row(`wasm: ${look}`, median(ratios(drawn, unit)), "units", atMost(bar));
    guide("that is", median(drawn), "ms");
  }
}

async function grids() {
  const sizes = [1024, 4096];
  const [small, large] = await inTurn(5, ...sizes.map((size) => [native, `grid ${size} 1`]));
  const cells = ([size]) => (size * size) / 1.6;
  row("µs a cell, 4096 x 2560", (median(large) * 1000) / cells([4096]), "µs", atMost(0.5));
  row("exponent from 1024 x 640 on", Math.log(median(ratios(large, small))) / Math.log(16), "", atMost(1.05));
  const passed = async (threads) => {
    const begun = performance.now();
    await native.run(`grid 4096 ${threads}`);
    return performance.now() - begun;
  };
  const [one, two] = [await passed(1), await passed(2)];
  guide("time that passes on two threads / on one", two / one, "×");
}

async function labels() {
  const [bare, labelled] = await inTurn(15, [native, "labelled none"], [native, "labelled some"]);
  row("native: with labels / without", median(ratios(labelled, bare)), "×", atMost(1.2, 1.12));
  guide("with labels", median(labelled), "ms");
  for (const many of ["some", "many"]) {
    const [first, moved] = await inTurn(15, [native, `labels ${many} anew`], [native, `labels ${many} kept`]);
    row(`native: ${many} labels of a moved picture / of a first one`, median(ratios(moved, first)), "×", atMost(0.3, 0.22));
    guide("of a first one", median(first), "ms");
  }
}

async function woods() {
  const [bare, wooded] = await inTurn(15, [native, "wooded 0"], [native, "wooded 1"]);
  row("native: with woods and hills / without", median(ratios(wooded, bare)), "×", atMost(1.25, 1.15));
  guide("with woods and hills", median(wooded), "ms");
}

async function whole() {
  const [few, many] = [100_000, 1_000_000];
  for (const growth of ["drainage", "colonize"]) {
    const tasks = [few, many].map((attractors) => [native, `whole ${growth} ${attractors}`]);
    const [short, long] = await inTurn(3, ...tasks);
    const exponent = Math.log(median(ratios(long, short))) / Math.log(many / few);
    row(`${growth}: exponent from 100,000 to 1,000,000 attractors`, exponent, "", atMost(1.1));
    guide("N = 100,000", median(short), "ms");
    guide("N = 1,000,000", median(long), "ms");
  }
  for (const form of ["json", "geojson", "svg"]) {
    const [written] = await inTurn(5, [native, `file ${form} ${few}`]);
    guide(`${form} of the second, N = 100,000`, median(written), "ms");
  }
}

async function png() {
  for (const style of ["ink", "atlas"]) {
    const tasks = [`png ${style}`, `balanced-png ${style}`];
    const [size, balancedSize] = [(await native.run(tasks[0])).result, (await native.run(tasks[1])).result];
    const [ours, balanced] = await inTurn(7, ...tasks.map((task) => [native, task]));
    row(`${style}: the crate's balanced compression / ours`, median(ratios(balanced, ours)), "×", atLeast(1.5, 2));
    guide("ours", median(ours), "ms");
    row(`${style}: size of ours / balanced`, size / balancedSize, "×", atMost(1.1));
  }
}

function page() {
  if (!existsSync("www/dist/index.html")) {
    console.log("  The page is not built: make site");
    return;
  }
  const npm = ["--silent", "--prefix", "www", "run", "bench:page"];
  const printed = execFileSync("npm", npm, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  for (const [phase, found] of Object.entries(JSON.parse(printed.trim().split("\n").at(-1)))) {
    const { p95, longest, frames, seconds } = found;
    row(`${phase}: gap between frames, 95th percentile`, p95, "ms", atMost(17.5, 17));
    row(`${phase}: longest callback`, longest, "ms", atMost(33, 12));
    guide(`${phase}: ${frames} frames take`, seconds, "s");
  }
}

/** The median of each slider, the slowest of which counts; a relief is a draft of its own. */
function sliders() {
  if (!existsSync("www/dist/index.html")) {
    console.log("  The page is not built: make site");
    return;
  }
  const npm = ["--silent", "--prefix", "www", "run", "bench:sliders"];
  const printed = execFileSync("npm", npm, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  const slowest = (all) => all.sort(([, one], [, other]) => other.p50 - one.p50)[0];
  for (const [map, { sliders: found, longest }] of Object.entries(JSON.parse(printed.trim().split("\n").at(-1)))) {
    if (map !== "many") {
      const isRelief = ([key]) => ["mountains", "plains", "shade"].includes(key);
      const all = Object.entries(found);
      for (const [what, some, bar] of [
        ["drafts", all.filter((one) => !isRelief(one)), atMost(50, 16)],
        ["relief", all.filter(isRelief), atMost(50, 16)],
      ]) {
        const [key, { p50, p95 }] = slowest(some);
        row(`${map}: ${what}, the slowest, ${key}`, p50, "ms", bar);
        guide(`${map}: ${key}, 95th percentile`, p95, "ms");
      }
    }
    row(`${map === "many" ? "300,000" : map}: longest task on the page's thread, if longer than 50 ms`, longest, "ms", atMost(50));
  }
}

function lighthouse() {
  if (!existsSync("www/dist/index.html")) {
    console.log("  The page is not built: make site");
    return;
  }
  const npm = ["--silent", "--prefix", "www", "run", "lighthouse", "figures"];
  const last = execFileSync("npm", npm, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] }).trim().split("\n").at(-1);
  if (!last.startsWith("{")) console.log(`  ${last}`);
  else for (const [form, score] of Object.entries(JSON.parse(last))) row(`performance, ${form}`, score, "of 100", atLeast(50, 90));
}

function widget() {
  if (!existsSync("www/dist-widget/river-seed.js")) {
    console.log("  The widget is not built: make widget");
    return;
  }
  const npm = ["--silent", "--prefix", "www", "run", "bench:widget"];
  const printed = execFileSync("npm", npm, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  for (const [place, recipes] of Object.entries(JSON.parse(printed.trim().split("\n").at(-1)))) {
    for (const [recipe, { frame, longest }] of Object.entries(recipes)) {
      row(`${place}, ${recipe}: longest task on the page`, longest, "ms", atMost(recipe === "default" ? 50 : 100, 50));
      row(`${place}, ${recipe}: first picture after the wasm has arrived`, frame, "ms", atMost(100));
    }
  }
}

function size() {
  const files = {
    "the element's, without labels,": "www/pkg-make/riverseed_bg.wasm",
    "the element's, with labels,": "www/pkg-label/riverseed_label_bg.wasm",
    "the page's": "www/pkg-engine/riverseed_engine_bg.wasm",
  };
  const bars = {
    "the element's, without labels,": atMost(208, 200),
    "the element's, with labels,": atMost(361, 340),
    "the page's": atMost(452, 440),
  };
  for (const [whose, file] of Object.entries(files)) {
    const bytes = readFileSync(file);
    row(`${whose} wasm, brotli`, brotliCompressSync(bytes).length / 1000, "kB", bars[whose]);
    guide(`${whose} wasm, bare`, bytes.length / 1000, "kB");
  }
}

// ---- the two sides: run(task) → { ms, result }

/** The native program; cargo brings it up to date first. */
async function nativeSide() {
  const child = spawn("cargo", ["bench", "--quiet", "--features", "json,png", "--bench", "figures"], {
    stdio: ["pipe", "pipe", "inherit"],
    // wasm memory is never given back to the system, so a repetition finds it there. Nor is it here: the time is
    // that of our work, not that of the kernel clearing pages.
    env: { ...process.env, GLIBC_TUNABLES: "glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=4000000000" },
  });
  const lines = createInterface(child.stdout)[Symbol.asyncIterator]();
  const answer = async () => Number((await lines.next()).value);
  const spent = processorTime(await answer());
  return {
    name: "native",
    async run(task) {
      const before = spent();
      child.stdin.write(`${task}\n`);
      const result = await answer();
      // Not a number: no such task, or the program is gone.
      if (Number.isNaN(result)) throw new Error(`the native program does not do '${task}'`);
      return { ms: spent() - before, result };
    },
    close: () => child.stdin.end(),
  };
}

/** A clock of the milliseconds that another process, which is waiting for us, has spent on a processor. */
function processorTime(pid) {
  const file = `/proc/${pid}/schedstat`; // its first number, in ns
  if (!existsSync(file)) return () => performance.now();
  return () => Number(readFileSync(file, "utf8").split(" ")[0]) / 1e6;
}

/** A fresh instance of the wasm module. */
function wasmSide() {
  const require = createRequire(import.meta.url);
  const path = require.resolve("../target/figures-wasm/figures_wasm.js");
  delete require.cache[path];
  const figures = new (require(path).Figures)();
  return {
    name: "wasm",
    async run(task) {
      if (!figures.prepare(task)) throw new Error(`the wasm module does not do '${task}'`);
      const before = process.cpuUsage();
      const result = figures.run(task);
      const { user, system } = process.cpuUsage(before);
      return { ms: (user + system) / 1000, result };
    },
    memory: () => figures.memory(),
  };
}

/**
 * Runs works, [side, task, times in a row = 1], in turn; returns for each work its times in ms. Before, each is run
 * until V8 has compiled it at its best, or natively until memory is there.
 */
async function inTurn(rounds, ...works) {
  const warmUp = works.some(([side]) => side.name === "wasm") ? 2 : 1;
  const times = works.map(() => []);
  for (let round = -warmUp; round < rounds; round++) {
    const results = new Map();
    for (const [i, [side, task, inARow = 1]] of works.entries()) {
      const some = [];
      for (let j = 0; j < inARow; j++) {
        const { ms, result } = await side.run(task);
        if ((results.get(task) ?? result) !== result) throw new Error(`native and wasm do not agree on '${task}'`);
        if (inARow === 1) results.set(task, result);
        some.push(ms);
      }
      if (round >= 0) times[i].push(median(some));
    }
  }
  return times;
}

function ratios(above, below) {
  return above.map((time, i) => time / below[i]);
}

function less(whole, part) {
  return whole.map((time, i) => time - part[i]);
}

function median(numbers) {
  return numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

// ---- the table

function row(what, value, unit, { floor, aim, meets }) {
  const verdict = meets(value, aim) ? "" : meets(value, floor) ? "floor met" : "MISSED";
  if (verdict === "MISSED") missed.push(what);
  print(`  ${what}`, `${written(value)} ${unit}`, `${floor} ${unit}`, `${aim} ${unit}`, verdict);
}

function guide(what, value, unit) {
  print(`      ${what}`, `${written(value)} ${unit}`);
}

/** Three digits, without an exponent. */
function written(value) {
  return Number(value.toPrecision(3)).toString();
}

function print(what, ...cells) {
  const [measured = "", floor = "", aim = "", verdict = ""] = cells;
  const columns = [what.padEnd(78), ...[measured, floor, aim].map((cell) => cell.trim().padStart(11)), ` ${verdict}`];
  console.log(columns.join("").trimEnd());
}
