import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { folded, hashes, listed } from "../../scripts/words.mjs";

test("listed words are read without accents, as the crate reads names", () => {
  expect(["Þáčæñš", "Ždrā"].map(folded)).toEqual(["thacaens", "zdra"]);
});

test("the hashes that the crate's test looks for are those of the lists", async () => {
  expect((await listed()).size).toBeGreaterThan(2000);
  expect(readFileSync("../tests/listed.txt", "utf8") === (await hashes()), "node scripts/words.mjs").toBe(true);
});
