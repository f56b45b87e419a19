// Which made-up names hold a word that nobody wants to read, by two open lists (`naughty-words`, CC BY 4.0, and `cuss`, MIT). The names are
// those that the example `words` prints; the crate knows the fragments by their hashes alone, src/name/refused.txt.
//
//   node scripts/words.mjs    adds the hashes of what is found, until nothing is; a unit test fails when something would be

import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const REFUSED = new URL("../../src/name/refused.txt", import.meta.url);

/** The lengths of fragments that the crate looks at. */
const SHORTEST = 4;
const LONGEST = 12;
/** What `cuss` is sure of: that a word is used to offend, and hardly otherwise. */
const SURE = 2;

/** Lower-case letters without accents, as the crate reads names. */
export function folded(word) {
  const plain = word.toLowerCase().normalize("NFD").replaceAll(/\p{M}/gu, "");
  return plain
    .replaceAll("þ", "th")
    .replaceAll("æ", "ae")
    .replaceAll(/[^a-z]/g, "");
}

/** What no name should hold: listed words of Latin letters, folded. */
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

/** The names of so many languages, so many of each. */
export function names(languages, words) {
  const call = ["run", "--quiet", "--all-features", "--example", "words", "--", languages, words].map(String);
  const printed = execFileSync(`${ROOT}scripts/env.sh`, ["cargo", ...call], { cwd: ROOT, maxBuffer: 1 << 28 });
  return printed.toString().trim().split("\n");
}

/** The listed fragments that names hold. */
export function held(fragments, names) {
  const found = new Set();
  for (const name of names.map(folded)) {
    for (let start = 0; start + SHORTEST <= name.length; start += 1) {
      for (let end = start + SHORTEST; end <= Math.min(name.length, start + LONGEST); end += 1) {
        const fragment = name.slice(start, end);
        if (fragments.has(fragment)) found.add(fragment);
      }
    }
  }
  return found;
}

/** FNV-1a of 32 bits, as eight hexadecimal digits. */
function hash(text) {
  let hash = 0x811c9dc5;
  for (const letter of text) hash = Math.imul(hash ^ letter.charCodeAt(0), 0x01000193) >>> 0;
  return hash.toString(16).padStart(8, "0");
}

async function refresh() {
  const fragments = await listed();
  for (;;) {
    const found = held(fragments, names(20_000, 50));
    const before = readFileSync(REFUSED, "utf8").split("\n").filter(Boolean);
    console.log(`${found.size} more of ${fragments.size} fragments`);
    const isNew = [...found].map(hash).some((line) => !before.includes(line));
    if (!isNew) return;
    const all = [...new Set([...before, ...[...found].map(hash)])].sort();
    writeFileSync(REFUSED, all.map((line) => `${line}\n`).join(""));
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await refresh();
