import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { TYPING_MS, Typing, type Verdict } from "../../src/browser/typing.ts";

let acted: string[] = [];
let typing: Typing<string>;

beforeEach(() => {
  vi.useFakeTimers();
  acted = [];
  typing = new Typing((key) => acted.push(key));
});

afterEach(() => {
  vi.useRealTimers();
});

/** Presses keys with this time from one to the next; what was said of each. */
function press(text: string, everyMs = 200): Verdict[] {
  return [...text].map((key) => {
    const verdict = typing.judge(key, key);
    if (verdict === "acts") acted.push(key);
    vi.advanceTimersByTime(everyMs);
    return verdict;
  });
}

test("of a sentence nothing acts, not even its first letter, its spaces or its full stop", () => {
  for (const everyMs of [0, 100, TYPING_MS - 1]) {
    press("Draw a country, please. OK?", everyMs);
    vi.advanceTimersByTime(10 * TYPING_MS);
    expect(acted, `${everyMs}`).toEqual([]);
  }
});

test("a letter that nothing follows acts, half a second later", () => {
  expect(press("r", 0)).toEqual(["held"]);
  vi.advanceTimersByTime(TYPING_MS - 1);
  expect(acted).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(acted).toEqual(["r"]);
});

test("the letter that acted last acts at once, until another character comes", () => {
  press("r", TYPING_MS);
  expect(press("rRr", 50)).toEqual(["acts", "acts", "acts"]);
  press("o", TYPING_MS);
  expect(press("r", TYPING_MS)).toEqual(["held"]);
  expect(acted).toEqual(["r", "r", "R", "r", "o", "r"]);
});

test("a letter that is pressed again and again acts as often", () => {
  press("rrr", 100);
  vi.advanceTimersByTime(TYPING_MS);
  expect(acted).toEqual(["r", "r", "r"]);
});

test("signs act at once, unless a letter came just before", () => {
  expect(press("..+0?[", 10)).toEqual(["acts", "acts", "acts", "acts", "acts", "acts"]);
  expect(press("a.", 100)).toEqual(["held", "typed"]);
  vi.advanceTimersByTime(TYPING_MS);
  expect(press(".")).toEqual(["acts"]);
  expect(acted.join("")).toBe("..+0?[.");
});

test("letters of any script are letters", () => {
  expect(press("جع", 100)).toEqual(["held", "typed"]);
});
