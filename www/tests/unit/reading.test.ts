import { expect, test } from "vitest";
import { CAPS, read } from "../../src/engine/reading.ts";
import { engine } from "../core.ts";

const request = (text: string, isDark = false): Parameters<typeof read>[1] => ({ text, isDark });

test("a link is read as the core reads it", () => {
  expect(read(engine, request("curl=0.6&seed=r%C4%81t%C4%81&aspect=2"))).toEqual({
    link: engine.readLink("curl=0.6&seed=rātā&aspect=2").link,
    seed: "rātā",
    aspect: 2,
    notices: [],
  });
});

for (const { growth, key, bound, isLeast } of CAPS) {
  test(`${key} has a bound, and going over it is said`, () => {
    const over = isLeast ? bound - 1 : bound + 1;
    const { link, notices } = read(engine, request(`growth=${growth}&${key}=${over}`));
    expect(link).toBe(engine.readLink(`growth=${growth}&${key}=${bound}`).link);
    expect(notices).toEqual([{ key, message: expect.stringContaining(`${over}`) }]);
    expect(read(engine, request(`growth=${growth}&${key}=${bound}`)).notices).toEqual([]);
  });

  test(`where ${key} does nothing it has no bound`, () => {
    const other = growth === "brownian" ? "colonize" : "brownian";
    const link = `growth=${other}&sensitivity=${other === "brownian" ? 32 : 8}&attractors=${other === "brownian" ? 90_000 : 300}`;
    expect(read(engine, request(link))).toMatchObject({ link: engine.readLink(link).link, notices: [] });
  });
}

test("the default is within all bounds", () => {
  expect(read(engine, request(""))).toMatchObject({ link: engine.readLink("").link, notices: [] });
});

test("whatever the text, there is a reading", () => {
  for (const text of ["%", "&&&", "seed", "x".repeat(10_000), "seed=\u0000", "attractors=1e99"]) {
    const { link } = read(engine, request(text));
    expect(engine.readLink(link).notices).toEqual([]);
  }
});

const style = (link: string): string | null => new URLSearchParams(link).get("style");

test("on a dark page it is the dark style, unless another is chosen", () => {
  expect(style(read(engine, request("seed=a", true)).link)).toBe("dark");
  expect(style(read(engine, request("seed=a")).link)).toBeNull();
  expect(style(read(engine, request("style=map", true)).link)).toBe("map");
});
