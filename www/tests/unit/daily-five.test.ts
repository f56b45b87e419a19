import { expect, test } from "vitest";
import { type Dealt, dealOf, FIVE, type Is, keepSaid, resultLine, saidOn, today } from "../../src/apps/study/daily.ts";
import { linkBy, RECIPE_NAMES } from "../../src/apps/study/recipes.ts";
import { count, forget, ORIGINS, tallyIn, totalOf } from "../../src/apps/study/tally.ts";
import { nameOf } from "../../src/apps/study/told.ts";
import { chanceOf, oneOf } from "../../src/browser/chance.ts";

const LENGTHS = Array.from({ length: 32 }, (_, i) => 350 + 10 * i);
const DATES = Array.from({ length: 366 }, (_, i) => today(new Date(Date.UTC(2028, 0, 1 + i))));

/** All that decides a piece, as text: of a grown one, the first map that is tried. */
function told(dealt: Dealt): string {
  if (dealt.is === "real") return `real ${dealt.place}`;
  const { by, length, seedOf, chance } = dealt.order;
  return `${length} ${linkBy(by, seedOf(), chance)}`;
}

/** A storage of one text, like the browser's. */
function storageWith(text: string | null = null): Storage {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, text: string) => {
      kept = text;
    },
    removeItem: () => {
      kept = null;
    },
  } as unknown as Storage;
}

const denied = (): Storage => {
  throw new Error("denied");
};

test("chance of a text is the same everywhere, and even", () => {
  const chance = chanceOf("kauri");
  expect(Array.from({ length: 8 }, () => chance(1000))).toEqual([470, 788, 168, 713, 631, 181, 134, 636]);
  const counts = new Uint32Array(7);
  for (let i = 0; i < 7000; i++) {
    const one = chance(7);
    counts[one] = (counts[one] ?? 0) + 1;
  }
  expect(Math.min(...counts)).toBeGreaterThan(900);
  expect(Math.max(...counts)).toBeLessThan(1100);
  expect(oneOf(["only"], chance)).toBe("only");
});

test("the day is that of UTC", () => {
  expect(today(new Date("2026-11-25T23:59:59.999Z"))).toBe("2026-11-25");
  expect(today(new Date("2026-11-26T00:30:00+02:00"))).toBe("2026-11-25");
});

test("a date deals the same five each time, and another date other ones", () => {
  const deals = DATES.map((date) => dealOf(date, LENGTHS).map(told).join());
  expect(DATES.map((date) => dealOf(date, LENGTHS).map(told).join())).toEqual(deals);
  expect(new Set(deals).size).toBe(DATES.length);
});

test("about half of a year's pieces are real, none twice on a day, and all recipes and pieces have their turn", () => {
  const deals = DATES.map((date) => dealOf(date, LENGTHS));
  for (const deal of deals) {
    expect(deal).toHaveLength(FIVE);
    const real = deal.flatMap((dealt) => (dealt.is === "real" ? [dealt.place] : []));
    expect(new Set(real).size).toBe(real.length);
  }
  const pieces = deals.flat();
  const real = pieces.flatMap((dealt) => (dealt.is === "real" ? [dealt.place] : []));
  expect(real.length / pieces.length).toBeGreaterThan(0.46);
  expect(real.length / pieces.length).toBeLessThan(0.54);
  expect(new Set(real)).toEqual(new Set(LENGTHS.keys()));
  const recipes = pieces.flatMap((dealt) => (dealt.is === "grown" ? [dealt.order.by] : []));
  for (const name of RECIPE_NAMES) expect(recipes.filter((one) => one === name).length, name).toBeGreaterThan(90);
});

test("what is said of a day is kept for that day, and junk is the same as nothing", () => {
  const storage = storageWith();
  const said: Is[] = ["real", "grown", "grown"];
  expect(saidOn("2026-11-25", () => storage)).toEqual([]);
  keepSaid("2026-11-25", said, () => storage);
  expect(saidOn("2026-11-25", () => storage)).toEqual(said);
  expect(saidOn("2026-11-26", () => storage)).toEqual([]);
  for (const junk of ["", "null", "2026-11-25", "2026-11-25 rgrgrg", "2026-11-25 rx", "2026-11-25  r", "[".repeat(1e5)])
    expect(
      saidOn("2026-11-25", () => storageWith(junk)),
      junk,
    ).toEqual([]);
  keepSaid("2026-11-25", said, denied);
  expect(saidOn("2026-11-25", denied)).toEqual([]);
});

test("the line of a result says what was right, and not what was real", () => {
  expect(
    resultLine("2026-11-25", [true, true, false, true, true], "https://riverseed.example/real-or-grown.html"),
  ).toBe("Riverseed, real or grown, 2026-11-25: ●●○●● 4/5 https://riverseed.example/real-or-grown.html");
});

test("answers are counted by recipe, until they are forgotten", () => {
  const storage = storageWith();
  const kept = (): Storage => storage;
  expect(totalOf(tallyIn(kept))).toEqual({ asked: 0, right: 0 });
  count("real", true, kept);
  count("real", false, kept);
  count("trimmedCurl", true, kept);
  count("drainage", false, kept);
  const tally = tallyIn(kept);
  expect(tally.real).toEqual({ shown: 2, passed: 1 });
  expect(tally.trimmedCurl).toEqual({ shown: 1, passed: 1 });
  expect(tally.drainage).toEqual({ shown: 1, passed: 0 });
  expect(tally.original).toEqual({ shown: 0, passed: 0 });
  expect(totalOf(tally)).toEqual({ asked: 4, right: 2 });
  forget(kept);
  expect(totalOf(tallyIn(kept))).toEqual({ asked: 0, right: 0 });
});

test("junk in the storage counts as nothing, and leaves the other counts alone", () => {
  const nothing = tallyIn(() => storageWith());
  const junk = [
    "",
    "null",
    "[]",
    "7",
    '"real"',
    "{",
    '{"real":null}',
    '{"real":7}',
    '{"real":[1,1]}',
    '{"real":{"shown":1}}',
    '{"real":{"shown":1,"passed":2}}',
    '{"real":{"shown":-1,"passed":-1}}',
    '{"real":{"shown":1.5,"passed":1}}',
    '{"real":{"shown":"9","passed":"1"}}',
    '{"real":{"shown":1e999,"passed":1}}',
    '{"real":{"shown":1e15,"passed":1}}',
    '{"asked":20,"right":13}',
    '{"__proto__":{"real":{"shown":1,"passed":1}}}',
    "[".repeat(1e5),
  ];
  for (const text of junk)
    expect(
      tallyIn(() => storageWith(text)),
      text.slice(0, 60),
    ).toEqual(nothing);
  const mixed = storageWith(
    '{"real":{"shown":1e15,"passed":1},"curl":{"shown":3,"passed":2},"x":{"shown":1,"passed":1}}',
  );
  expect(tallyIn(() => mixed)).toEqual({ ...nothing, curl: { shown: 3, passed: 2 } });
  count("real", true, () => mixed);
  expect(tallyIn(() => mixed)).toEqual({ ...nothing, real: { shown: 1, passed: 1 }, curl: { shown: 3, passed: 2 } });
});

test("counts stay below a million, and without storage nothing is counted", () => {
  const full = storageWith('{"real":{"shown":1000000,"passed":1000000}}');
  count("real", true, () => full);
  expect(tallyIn(() => full).real).toEqual({ shown: 1_000_000, passed: 1_000_000 });
  count("real", true, denied);
  forget(denied);
  expect(totalOf(tallyIn(denied))).toEqual({ asked: 0, right: 0 });
});

test("recipes have names that a reader understands", () => {
  expect(ORIGINS.map(nameOf)).toEqual([
    "Real rivers",
    "Space colonization",
    "Space colonization with momentum",
    "Space colonization with curl",
    "Space colonization, trimmed",
    "Space colonization with momentum, trimmed",
    "Space colonization with curl, trimmed",
    "Drainage",
  ]);
});
