import { expect, test } from "vitest";
import { engine } from "../core.ts";
import { table } from "../table.ts";

/** Fixed chance: the same links in every run. */
let state = 20_261_123;
function chance(below: number): number {
  state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
  return Math.floor((state / 2 ** 32) * below);
}

function pick<One>(some: readonly One[]): One {
  return some[chance(some.length)] as One;
}

const KEYS = [
  ...table.parameters.map(({ key }) => key),
  "preset",
  "utm_source",
  "__proto__",
  "constructor",
  "",
  "Seed",
  "%",
];
const VALUES = [
  ...["", "0", "-1", "1e999", "NaN", "Infinity", "0x10", "1,5", "99999999999999999999", "-0", ".5", "5.", "+1", " 1 "],
  ...[
    "island",
    "ISLAND",
    "atlas",
    "<script>alert(1)</script>",
    "%00",
    "%",
    "%zz",
    "%F0%9F",
    "\u{10ffff}",
    "\u202e",
    "נהר",
    "川".repeat(64),
  ],
  ...[
    "a".repeat(5000),
    "nesw",
    "ssss",
    "0.0.0",
    "true",
    "null",
    "undefined",
    "12.Name_t.Home",
    "..",
    "m0",
    "_",
    "a&b",
    "a=b",
    "+",
    "#",
  ],
];

function junk(): string {
  const parts = Array.from(
    { length: chance(9) },
    () => `${pick(KEYS)}${pick(["=", "=", "=", "", "=="])}${pick(VALUES)}`,
  );
  const text = pick(["", "?", "#", "&"]) + parts.join(pick(["&", "&", "&", "&&", ";"]));
  if (chance(4) > 0) return text;
  // Some are cut off, as by a chat.
  return text.slice(0, chance(text.length + 1));
}

test("ten thousand junk links are read: each is a map, and its own link reads back as it is", () => {
  for (let i = 0; i < 10_000; i++) {
    const link = junk();
    const { link: canonical, values } = engine.readLink(link);
    const again = engine.readLink(canonical);
    expect(again.link, link).toBe(canonical);
    expect(again.notices, link).toEqual([]);
    expect(new Map(again.values), link).toEqual(new Map(values));
  }
}, 120_000);
