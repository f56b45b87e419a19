// Measures works in turn: times on a busy machine are compared only with those of the same turn.

/**
 * Runs works, [side, task, times in a row = 1], in turn; returns for each work its times in ms. Before, each is run
 * until V8 has compiled it at its best, or natively until memory is there.
 */
export async function inTurn(rounds, ...works) {
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

export function ratios(above, below) {
  return above.map((time, i) => time / below[i]);
}

export function less(whole, part) {
  return whole.map((time, i) => time - part[i]);
}

export function median(numbers) {
  return numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];
}
