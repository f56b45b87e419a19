import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { FACES, table } from "../../scripts/type.mjs";
import { cut, TYPEFACES } from "../../scripts/typeface.mjs";

const at = (path: string) => readFileSync(new URL(`../../../src/annotate/glyph/${path}`, import.meta.url));

for (const face of FACES)
  test(`the table of ${face.name} type is what its font gives: \`node scripts/type.mjs\` writes it`, () => {
    expect(at(`${face.name}.bin`).equals(table(face))).toBe(true);
  });

for (const one of TYPEFACES)
  test(`${one.name} is what its font gives: \`node scripts/typeface.mjs\` writes it`, async () => {
    const file = readFileSync(new URL(`../../src/style/${one.name}`, import.meta.url));
    expect(file.equals(await cut(one))).toBe(true);
  });

test("the font's licence stands beside the table as it came with the font", () => {
  const licence = new URL("../../node_modules/@fontsource/eb-garamond/LICENSE", import.meta.url);
  expect(at("OFL.txt").equals(readFileSync(licence))).toBe(true);
});
