// Measures works in turn: times on a busy machine are compared only with those of the same turn.

/** The work that others are measured in: growing 100,000 attractors at R = 3. */
export const UNIT = "grow 100000 3";

/**
 * Runs works, [side, task, times in a row = 1], in turn; returns for each work its times in ms. Before, each is run
 * until V8 has compiled it at its best, or natively until memory is there.
 */
export async function inTurn(rounds, ...works) {
  const warmUp = warmUpFor(works.map(([side]) => side));
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

/**
 * Passes through a task that does another phase of the same work each time, and returns the number of that phase. Returns, for each of
 * `count` phases, its times in units, one for each pass.
 */
export async function inPhases(passes, side, task, count) {
  const units = Array.from({ length: count }, () => []);
  for (let pass = -warmUpFor([side]); pass < passes; pass++) {
    const unit = (await side.run(UNIT)).ms;
    const times = new Array(count).fill(0); // a map may lack a phase
    for (let phase = -1; phase < count - 1; ) {
      const { ms, result } = await side.run(task);
      times[result] = ms;
      phase = result;
    }
    if (pass >= 0) for (const [phase, ms] of times.entries()) units[phase].push(ms / unit);
  }
  return units;
}

/** Returns how often works are run before they are measured. */
function warmUpFor(sides) {
  return sides.some((side) => side.name === "wasm") ? 2 : 1;
}

export function ratios(above, below) {
  return above.map((time, i) => time / below[i]);
}

export function less(whole, part) {
  return whole.map((time, i) => time - part[i]);
}

export function sum(numbers) {
  return numbers.reduce((all, one) => all + one, 0);
}

/** Returns the middle number, or the mean of the two in the middle. */
export function median(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b);
  const half = sorted.length / 2;
  return (sorted[Math.ceil(half) - 1] + sorted[Math.floor(half)]) / 2;
}
