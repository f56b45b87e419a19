/** The core's table of damaged links, which all are of one map. */

import { readFileSync } from "node:fs";

const ROWS = readFileSync(new URL("../../src/recipe/given/mangled.rs", import.meta.url), "utf8").matchAll(
  /^ {4}\((".*"), (true|false)\),$/gm,
);
/** The links, and whether each is damaged or only in an address. */
export const MANGLED = [...ROWS].map(([, text = "", isDamaged]): [text: string, isDamaged: boolean] => [
  JSON.parse(text.replace(/\\u\{(\w+)\}/g, (_, code: string) => String.fromCodePoint(Number.parseInt(code, 16)))),
  isDamaged === "true",
]);
