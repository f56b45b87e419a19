// The page and the element in a browser, and what they weigh.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { brotliCompressSync } from "node:zlib";

import { atLeast, atMost, guide, remark, row } from "../table.mjs";

export const GROUPS = {
  "The page at 1024², while 100,000 attractors grow, then while the rivers of 6,000 meander": page,
  "A slider of the page moves: from its event to other pixels of a map of 20,000, in a window of 1440 by 900": sliders,
  "The page by Lighthouse's performance, a phone and a desktop, medians of five": lighthouse,
  "A widget in a post, grown in a worker, then on the page itself": widget,
  "The wasm file of the page": size,
};

const SITE = { file: "www/dist/index.html", lacks: "The page is not built: make site" };
const WIDGET = { file: "www/dist-widget/river-seed.js", lacks: "The widget is not built: make widget" };

function* page() {
  for (const [phase, found] of yield* measured(SITE, "bench:page")) {
    const { p95, longest, frames, seconds } = found;
    yield row(`${phase}: gap between frames, 95th percentile`, p95, "ms", atMost(17.5, 17));
    yield row(`${phase}: longest callback`, longest, "ms", atMost(33, 12));
    yield guide(`${phase}: ${frames} frames take`, seconds, "s");
  }
}

/** The median of each slider, the slowest of which counts; a relief is a draft of its own. */
function* sliders() {
  const slowest = (all) => all.toSorted(([, one], [, other]) => other.p50 - one.p50)[0];
  const isRelief = ([key]) => ["mountains", "plains", "shade"].includes(key);
  for (const [map, { sliders: found, longest }] of yield* measured(SITE, "bench:sliders")) {
    if (map !== "many") {
      const all = Object.entries(found);
      for (const [what, some] of [
        ["drafts", all.filter((one) => !isRelief(one))],
        ["relief", all.filter(isRelief)],
      ]) {
        const [key, { p50, p95 }] = slowest(some);
        yield row(`${map}: ${what}, the slowest, ${key}`, p50, "ms", atMost(50, 16));
        yield guide(`${map}: ${key}, 95th percentile`, p95, "ms");
      }
    }
    const whose = map === "many" ? "300,000" : map;
    yield row(`${whose}: longest task on the page's thread, if longer than 50 ms`, longest, "ms", atMost(50));
  }
}

function* lighthouse() {
  for (const [form, score] of yield* measured(SITE, "lighthouse", "figures")) {
    yield row(`performance, ${form}`, score, "of 100", atLeast(50, 90));
  }
}

function* widget() {
  for (const [place, recipes] of yield* measured(WIDGET, "bench:widget")) {
    for (const [recipe, { frame, longest }] of Object.entries(recipes)) {
      const most = recipe === "default" ? 50 : 100;
      yield row(`${place}, ${recipe}: longest task on the page`, longest, "ms", atMost(most, 50));
      yield row(`${place}, ${recipe}: first picture after the wasm has arrived`, frame, "ms", atMost(100));
    }
  }
}

function* size() {
  for (const [whose, file, bar] of [
    ["the element's, without labels,", "www/pkg-make/riverseed_bg.wasm", atMost(208, 200)],
    ["the element's, with labels,", "www/pkg-label/riverseed_label_bg.wasm", atMost(361, 340)],
    ["the page's", "www/pkg-engine/riverseed_engine_bg.wasm", atMost(452, 440)],
  ]) {
    if (!existsSync(file)) {
      yield remark(`${file} is not built: make wasm`);
      continue;
    }
    const bytes = readFileSync(file);
    yield row(`${whose} wasm, brotli`, brotliCompressSync(bytes).length / 1000, "kB", bar);
    yield guide(`${whose} wasm, bare`, bytes.length / 1000, "kB");
  }
}

/**
 * Runs a script of www, whose last line is JSON. Returns its entries; none, with a word why, if what it measures is not built, or if the
 * script says that it cannot measure here.
 */
function* measured({ file, lacks }, ...script) {
  if (!existsSync(file)) {
    yield remark(lacks);
    return [];
  }
  const npm = ["--silent", "--prefix", "www", "run", ...script];
  const printed = execFileSync("npm", npm, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  const last = printed.trim().split("\n").at(-1);
  if (last.startsWith("{")) return Object.entries(JSON.parse(last));
  yield remark(last);
  return [];
}
