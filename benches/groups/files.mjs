// Files: of whole maps, of heights, and of pictures. All natively.

import { execFileSync } from "node:child_process";
import { join } from "node:path";

import { footprint } from "../processes.mjs";
import { atLeast, atMost, guide, remark, row } from "../table.mjs";
import { inTurn, median, ratios, UNIT } from "../turns.mjs";

export const GROUPS = {
  "Whole maps with their files, natively: islands with trim=0 and their relief": whole,
  "A default map of 100,000 parcels to JSON, natively, in units of growing 100,000 attractors at R = 3": json,
  "Heights of a default map at 4096 x 2560, by the command line in a process of its own": heights,
  "A picture of 2048² as PNG, natively": png,
};

async function* whole({ native }) {
  const [few, many] = [100_000, 1_000_000];
  for (const growth of ["drainage", "colonize"]) {
    const tasks = [few, many].map((attractors) => [native, `whole ${growth} ${attractors}`]);
    const [short, long] = await inTurn(3, ...tasks);
    const exponent = Math.log(median(ratios(long, short))) / Math.log(many / few);
    yield row(`${growth}: exponent from 100,000 to 1,000,000 attractors`, exponent, "", atMost(1.05));
    yield guide("N = 100,000", median(short), "ms");
    yield guide("N = 1,000,000", median(long), "ms");
  }
  for (const form of ["json", "geojson", "svg"]) {
    const [written] = await inTurn(5, [native, `file ${form} ${few}`]);
    yield guide(`${form} of the second, N = 100,000`, median(written), "ms");
  }
}

async function* json({ native }) {
  const tasks = ["atlas", "ink"].map((style) => `to-json style=${style}&attractors=100000`);
  const [unit, raised, flat] = await inTurn(5, ...[UNIT, ...tasks].map((task) => [native, task]));
  yield row(
    "native: from the link to the file, with the relief of atlas",
    median(ratios(raised, unit)),
    "units",
    atMost(14),
  );
  yield guide("that is", median(raised), "ms");
  yield guide("in ink", median(ratios(flat, unit)), "units");
}

async function* heights() {
  const options = ["render", "seed=kauri", "--raster-size", "4096", "-o", "target/figures.heights.png"];
  const program = riverseed();
  const found = [];
  for (let i = 0; i < 3; i++) found.push(await footprint(program, options));
  if (found.includes(null)) {
    yield remark("This system does not tell what a process takes");
    return;
  }
  yield row("the greatest memory of the process", median(found.map(({ megabytes }) => megabytes)), "MB", atMost(300));
  const ms = median(found.map(({ ms }) => ms));
  yield guide("a pixel, with all that comes before, on all processors together", (ms * 1000) / (4096 * 2560), "µs");
}

/** Returns the path of the command line, which cargo brings up to date first. */
function riverseed() {
  execFileSync("cargo", ["build", "--quiet", "--release", "--package", "riverseed-cli"], { stdio: "inherit" });
  return join(process.env.CARGO_TARGET_DIR ?? "target", "release/riverseed");
}

async function* png({ native }) {
  for (const style of ["ink", "atlas"]) {
    const tasks = [`png ${style}`, `balanced-png ${style}`];
    const [size, balancedSize] = [(await native.run(tasks[0])).result, (await native.run(tasks[1])).result];
    const [ours, balanced] = await inTurn(7, ...tasks.map((task) => [native, task]));
    yield row(
      `${style}: the crate's balanced compression / ours`,
      median(ratios(balanced, ours)),
      "×",
      atLeast(1.5, 2),
    );
    yield guide("ours", median(ours), "ms");
    yield row(`${style}: size of ours / balanced`, size / balancedSize, "×", atMost(1.1));
  }
}
