// Writes the page's typeface, src/style/*.woff2: EB Garamond, which names and labels on the map use as well, reduced to
// the characters that the
// page sets in it. Characters that it lacks are set in the reader's own serif.
//
//   node scripts/typeface.mjs    writes the files again; a unit test fails if they differ from the font's package

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import subset from "subset-font";

const FILES = new URL("../node_modules/@fontsource/eb-garamond/files/", import.meta.url);
const PLACE = new URL("../src/style/", import.meta.url);

const SIGNS = " ,.;:!?'’-–—…·&()";
const ENGLISH = between("A", "Z") + between("a", "z") + SIGNS;
/** The characters of seeds and names, for the languages of western Europe. */
const LATIN = `${ENGLISH + between("0", "9")}“”‘"#/+${between("À", "ÿ")}`;

/** The typefaces: upright for headings, italic for names and seeds. */
export const TYPEFACES = [
  { name: "garamond.woff2", of: "eb-garamond-latin-400-normal.woff2", letters: ENGLISH },
  { name: "garamond-italic.woff2", of: "eb-garamond-latin-400-italic.woff2", letters: LATIN },
];

/** Returns the bytes of a typeface. */
export function cut({ of, letters }) {
  // Without the swashes and ligatures that features would add.
  return subset(readFileSync(new URL(of, FILES)), letters, { targetFormat: "woff2", noLayoutClosure: true });
}

function between(first, last) {
  const codes = [];
  for (let code = first.charCodeAt(0); code <= last.charCodeAt(0); code++) codes.push(code);
  return String.fromCharCode(...codes);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const one of TYPEFACES) writeFileSync(new URL(one.name, PLACE), await cut(one));
}
