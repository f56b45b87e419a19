// Whole maps as people meet them, as wasm: from a link to a finished picture of 1024 x 640. A unit is what growing 100,000 attractors
// at R = 3 takes in the same turn.

import { coldly } from "../processes.mjs";
import { atLeast, atMost, guide, remark, row } from "../table.mjs";
import { inPhases, inTurn, less, median, ratios, sum, UNIT } from "../turns.mjs";

export const GROUPS = {
  "A whole default map at 1024 x 640, from the link to the finished picture, in units of growing 100,000 attractors at R = 3":
    usual,
  "Whole default maps of eight words, in the same units": words,
  "The first whole default map of a process, in the same units": cold,
  "The phases of a whole default map in atlas with labels, in the same units": phases,
  "Whole default maps of more and more parcels": parcels,
};

const INK = "style=ink&labels=none";
const ATLAS = "style=atlas&labels=none";
const NAMED = "style=atlas&labels=some";
const LOOKS = [INK, ATLAS, NAMED];

/** Words whose countries differ: the dearest of these maps takes four times as long as the cheapest. */
const WORDS = ["Thornwick", "Oriel", "Selkie", "kauri", "Oakhollow", "Veldemar", "Tamsin", "Lundmark"];

/** Phases by the numbers that the task `phases` returns. */
const PHASES = ["land and parcels", "growing", "drowning", "shaping", "meandering", "deltas and relief", "painting"];

async function* usual({ native, wasm }) {
  const [natively, asWasm] = [await pictures(native), await pictures(wasm)];
  const same = new Set(asWasm.filter((picture, i) => picture === natively[i]));
  yield row("looks that native and wasm paint alike, and each otherwise than the others", same.size, "", atLeast(3));
  const [ink, atlas, named] = await inLooks(9, wasm, "");
  yield row(`wasm: ${INK}`, median(ink), "units", atMost(3));
  yield row(`wasm: ${ATLAS}`, median(atlas), "units", atMost(4.2));
  yield row(`wasm: ${NAMED}`, median(named), "units", atMost(5.2));
  yield row("wasm: its labels, the last minus the one before", median(less(named, atlas)), "units", atMost(1));
  const [unit] = await inTurn(9, [wasm, UNIT]);
  yield guide("a unit", median(unit), "ms");
}

/** Returns a hash of the map's picture in each look. */
async function pictures(side) {
  const hashes = [];
  for (const look of LOOKS) hashes.push((await side.run(`map-picture ${look}`)).result);
  return hashes;
}

async function* words({ wasm }) {
  const units = LOOKS.map(() => []);
  for (const word of WORDS) {
    const looks = await inLooks(3, wasm, `seed=${word}&`);
    for (const [i, some] of looks.entries()) units[i].push(median(some));
  }
  for (const [i, look] of LOOKS.entries()) {
    yield guide(`wasm: ${look}, the median word`, median(units[i]), "units");
    yield remark(`        ${WORDS.map((word, j) => `${word} ${units[i][j].toFixed(1)}`).join(", ")}`);
  }
}

/** Returns what a map takes in each look, in units, one for each turn. `before` stands before the look in its link. */
async function inLooks(rounds, side, before) {
  const maps = LOOKS.map((look) => [side, `map ${before}${look}`]);
  const [unit, ...times] = await inTurn(rounds, [side, UNIT], ...maps);
  return times.map((some) => ratios(some, unit));
}

async function* cold({ wasm }) {
  const PROCESSES = 5;
  const task = `map ${NAMED}`;
  const [warm, unit] = await inTurn(PROCESSES, [wasm, task], [wasm, UNIT]);
  const first = Array.from({ length: PROCESSES }, () => coldly(task));
  yield row(`wasm: ${NAMED}`, median(first) / median(unit), "units", atMost(11));
  yield guide("that is", median(first), "ms");
  yield guide("the first map / a later one, whose code V8 has compiled at its best", median(first) / median(warm), "×");
}

async function* phases({ wasm }) {
  const units = await inPhases(5, wasm, `phases ${NAMED}`, PHASES.length);
  for (const [i, phase] of PHASES.entries()) yield guide(`wasm: ${phase}`, median(units[i]), "units");
  yield guide("all together", median(units[0].map((_, pass) => sum(units.map((phase) => phase[pass])))), "units");
}

async function* parcels({ wasm }) {
  const count = async (what, link) => (await wasm.run(`count ${what} ${link}`)).result;
  for (const look of [INK, NAMED]) {
    for (const attractors of [5_000, 20_000, 80_000, 320_000]) {
      const link = `${look}&attractors=${attractors}`;
      const [parcels, vertices] = [await count("parcels", link), await count("vertices", link)];
      const [times] = await inTurn(3, [wasm, `map ${link}`]);
      yield guide(`wasm: ${look}, ${parcels} parcels: a thousand parcels`, (median(times) * 1000) / parcels, "ms");
      yield guide(`${vertices} vertices: a thousand vertices`, (median(times) * 1000) / vertices, "ms");
    }
  }
}
