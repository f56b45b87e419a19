/** Names files after their seed, which is hostile text, and the details that distinguish them. */

/** The most characters of the seed in a name, so that the whole name is short enough for every system. */
const LONGEST = 40;

/** Names that Windows reserves for devices, whatever their extension. */
const DEVICES = /^(con|prn|aux|nul|(com|lpt)\d)$/i;

/**
 * Makes a name from the seed's letters and digits, in any script and with hyphens for everything else, then details
 * such as the style, and the extension.
 */
export function fileName(seed: string, ending: string, ...details: readonly (string | number)[]): string {
  return `${[wordOf(seed), ...details].join("-")}.${ending}`;
}

function wordOf(seed: string): string {
  const letters = seed.normalize("NFC").replace(/[^\p{L}\p{M}\p{N}]+/gu, "-");
  const word = [...letters.replace(/^-/, "")].slice(0, LONGEST).join("").replace(/-$/, "");
  if (word === "" || !/[\p{L}\p{N}]/u.test(word)) return "riverseed";
  return DEVICES.test(word) ? `riverseed-${word}` : word;
}
