/** What files are called: after their seed, which is hostile text, and what else tells them apart. */

/** The most of a seed that a name has, in letters: with all else it is short enough for every system. */
const LONGEST = 40;

/** Names that Windows keeps for devices, whatever their ending. */
const DEVICES = /^(con|prn|aux|nul|(com|lpt)\d)$/i;

/** A name of a seed's letters and digits, of any script, all else as hyphens; of details, such as the style; and of an ending. */
export function fileName(seed: string, ending: string, ...details: readonly (string | number)[]): string {
  return `${[wordOf(seed), ...details].join("-")}.${ending}`;
}

function wordOf(seed: string): string {
  const letters = seed.normalize("NFC").replace(/[^\p{L}\p{M}\p{N}]+/gu, "-");
  const word = [...letters.replace(/^-/, "")].slice(0, LONGEST).join("").replace(/-$/, "");
  if (word === "" || !/[\p{L}\p{N}]/u.test(word)) return "riverseed";
  return DEVICES.test(word) ? `riverseed-${word}` : word;
}
