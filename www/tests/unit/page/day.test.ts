import { expect, test } from "vitest";
import { wordOf } from "../../../src/apps/page/day/day.ts";
import words from "../../../src/apps/page/day/words.json" with { type: "json" };
import { engine } from "../../core.ts";

/** All days of a year with a 29th of February. */
const DAYS = Array.from({ length: 366 }, (_, i) => new Date(2028, 0, 1 + i));

test("each day of a year has a word of its own", () => {
  expect(words).toHaveLength(366);
  expect(DAYS.map(wordOf)).toEqual(words);
  expect(new Set(words.map((word) => word.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase())).size).toBe(366);
});

test("a day has the same word every year, from its first minute to its last", () => {
  for (const year of [2025, 2026, 2027]) expect(wordOf(new Date(year, 2, 1))).toBe(wordOf(new Date(2028, 2, 1)));
  expect(wordOf(new Date(2026, 9, 25, 23, 59))).toBe(wordOf(new Date(2026, 9, 25, 0, 0)));
});

test("a link of nothing but the word reads back, and the words draw many kinds of country", () => {
  const kinds = new Set<string>();
  for (const word of words) {
    const { link, notices, values } = engine.readLink(new URLSearchParams({ seed: word }).toString());
    expect([new URLSearchParams(link).get("seed"), notices]).toEqual([word, []]);
    kinds.add(new Map(values).get("country") ?? "");
  }
  expect(kinds.size).toBeGreaterThan(20);
});
