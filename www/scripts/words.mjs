// Writes hashes of the words that nobody wants to read, by two open lists (`naughty-words`, CC BY 4.0, and `cuss`,
// MIT). They are hashes so that neither the source nor the program contains the words.
//
//   node scripts/words.mjs    writes tests/listed.txt, after a new version of a list; then a test in
//                             src/annotate/names/filter.rs says what is new

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";

const LISTED = new URL("../../tests/listed.txt", import.meta.url);

/** The lengths of fragments that the crate checks. */
const SHORTEST = 4;
const LONGEST = 12;
/** The rating in `cuss` of words that are hardly ever used but to offend. */
const SURE = 2;

/** Returns a word in lower case and without accents, as the crate reads names. */
export function folded(word) {
  const plain = word.toLowerCase().normalize("NFD").replaceAll(/\p{M}/gu, "");
  return plain
    .replaceAll("þ", "th")
    .replaceAll("æ", "ae")
    .replaceAll(/[^a-z]/g, "");
}

/** Returns the words that no name should contain: the listed ones in Latin letters, folded. */
export async function listed() {
  const words = [...naughtyWords(), ...(await cussWords())].filter((word) => /^[\p{Script=Latin}\p{M}]+$/u.test(word));
  const long = words.map(folded).filter(({ length }) => length >= SHORTEST && length <= LONGEST);
  return new Set(long);
}

function naughtyWords() {
  const folder = dirname(createRequire(import.meta.url).resolve("naughty-words"));
  const lists = readdirSync(folder).filter(
    (name) => name.endsWith(".json") && !name.includes("package") && name !== "bower.json",
  );
  return lists.flatMap((name) => JSON.parse(readFileSync(`${folder}/${name}`, "utf8")));
}

async function cussWords() {
  const all = await Promise.all(
    ["", "/es", "/fr", "/it", "/pt", "/pt-pt"].map((language) => import(`cuss${language}`)),
  );
  return all.flatMap(({ cuss }) => Object.keys(cuss).filter((word) => cuss[word] >= SURE));
}

/**
 * Returns FNV-1a of 64 bits as sixteen hexadecimal digits. With fewer, harmless fragments among a million names would
 * match.
 */
function hash(text) {
  let hash = 0xcbf29ce484222325n;
  for (const letter of text) hash = BigInt.asUintN(64, (hash ^ BigInt(letter.charCodeAt(0))) * 0x100000001b3n);
  return hash.toString(16).padStart(16, "0");
}

/** Returns the contents that tests/listed.txt should have. */
export async function hashes() {
  const hashes = [...(await listed())].map(hash).sort();
  return hashes.map((line) => `${line}\n`).join("");
}

if (process.argv[1] === fileURLToPath(import.meta.url)) writeFileSync(LISTED, await hashes());
