import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { table } from "../../scripts/type.mjs";

const at = (path: string) => readFileSync(new URL(`../../../src/glyph/${path}`, import.meta.url));

test("the table of type is what its font gives: `node scripts/type.mjs` writes it", () => {
  expect(at("garamond.bin").equals(table())).toBe(true);
});

test("the font's licence stands beside the table as it came with the font", () => {
  const licence = new URL("../../node_modules/@fontsource/eb-garamond/LICENSE", import.meta.url);
  expect(at("OFL.txt").equals(readFileSync(licence))).toBe(true);
});
