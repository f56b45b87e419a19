/** Chance: of this moment, or of a text, which is then the same everywhere. */

/** Returns a whole number from 0 to below its argument. All are equally likely, apart from a negligible bias. */
export type Chance = (below: number) => number;

export const chance: Chance = (below) =>
  Math.floor(((crypto.getRandomValues(new Uint32Array(1))[0] ?? 0) / 2 ** 32) * below);

/** Returns numbers that follow from a text: its FNV-1a hash, and from there on splitmix32. */
export function chanceOf(text: string): Chance {
  let state = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(text)) state = Math.imul(state ^ byte, 0x01000193);
  return (below) => {
    state = (state + 0x9e3779b9) | 0;
    const first = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    const second = Math.imul(first ^ (first >>> 15), 0x735a2d97);
    return Math.floor((((second ^ (second >>> 15)) >>> 0) / 2 ** 32) * below);
  };
}

/** Returns some items in another order. */
export function shuffled<Item>(items: readonly Item[], chance: Chance): Item[] {
  const all = [...items];
  for (let last = all.length - 1; last > 0; last--) {
    const other = chance(last + 1);
    [all[last], all[other]] = [all[other] as Item, all[last] as Item];
  }
  return all;
}

/** Returns one of several. */
export function oneOf<Type>(several: readonly [Type, ...Type[]], chance: Chance): Type {
  return several[chance(several.length)] ?? several[0];
}
