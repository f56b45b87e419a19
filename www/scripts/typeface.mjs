// The page's typeface, src/style/*.woff2: EB Garamond, of which names and labels on the map are too, cut down to the letters that the page
// sets in it. Whatever it lacks is set in the reader's own serif.
//
//   node scripts/typeface.mjs    writes the files again; a unit test fails when they are not what the font's package gives

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import subset from "subset-font";

const FILES = new URL("../node_modules/@fontsource/eb-garamond/files/", import.meta.url);
const PLACE = new URL("../src/style/", import.meta.url);

const SIGNS = " ,.;:!?'’-–—…·&()";
const ENGLISH = between("A", "Z") + between("a", "z") + SIGNS;
/** Seeds and names are in any of the languages of western Europe. */
const LATIN = `${ENGLISH + between("0", "9")}“”‘"#/+${between("À", "ÿ")}`;

/** Headings are upright, names and seeds are italic. */
export const TYPEFACES = [
  { name: "garamond.woff2", of: "eb-garamond-latin-400-normal.woff2", letters: ENGLISH },
  { name: "garamond-italic.woff2", of: "eb-garamond-latin-400-italic.woff2", letters: LATIN },
];

/** The bytes of one of them. */
export function cut({ of, letters }) {
  // Without the swashes and ligatures that features would bring in.
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
