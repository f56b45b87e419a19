import { expect, test } from "vitest";
import { folded, held, listed, names } from "../../scripts/words.mjs";

test("names are read without accents, as the crate reads them", () => {
  expect(["Þáčæñš", "Ždrā"].map(folded)).toEqual(["thacaens", "zdra"]);
});

test("fragments are found wherever they stand in a name, of four letters and more", () => {
  const fragments = new Set(["lend", "dell", "len", "dellend"]);
  expect(held(fragments, ["Dellendar", "Þilendis", "Dálennor"])).toEqual(new Set(["dell", "lend", "dellend"]));
});

test("of a million names in twenty thousand languages none holds a listed word", async () => {
  const fragments = await listed();
  expect(fragments.size).toBeGreaterThan(2000);
  const all = names(20_000, 50);
  expect(all.length).toBe(1_000_000);
  // What is new: `node scripts/words.mjs` adds it.
  expect([...held(fragments, all)]).toEqual([]);
}, 600_000);
