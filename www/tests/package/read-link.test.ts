/** Links in Node, read without growing their maps. */

import { spawnSync } from "node:child_process";
import { expect, test } from "vitest";
import { CONSUMERS } from "./installed.ts";

interface Heard {
  link?: string;
  seed?: string;
  alternative?: string;
  isMended?: boolean;
  beyondElement?: string[];
  error?: string;
}

/** Reads links in a process of its own, where the installed package is found. */
function read(...links: string[]): Heard[] {
  const program = `
    import { PageError, readLink } from "riverseed/node";
    const read = (link) => {
      try {
        return readLink(link);
      } catch (error) {
        return { error: error instanceof PageError && error.code === "bad-params" ? error.message : String(error) };
      }
    };
    console.log(JSON.stringify(${JSON.stringify(links)}.map(read)));`;
  const words = ["--input-type=module", "--eval", program];
  return JSON.parse(spawnSync(process.execPath, words, { cwd: CONSUMERS, encoding: "utf8" }).stdout);
}

test("a link is read in its canonical form, with the edition and with a style that it names", () => {
  expect(read("?curl=0.60&seed=caf%C3%A9+noir", "seed=a&style=atlas", "")).toEqual([
    {
      link: "seed=caf%C3%A9+noir&edition=1&curl=0.6",
      seed: "café noir",
      alternative: "Rivers grown from “café noir”",
      isMended: false,
      beyondElement: [],
    },
    {
      link: "seed=a&edition=1&style=atlas",
      seed: "a",
      alternative: "Rivers grown from “a”",
      isMended: false,
      beyondElement: [],
    },
    {
      link: "seed=kauri&edition=1",
      seed: "kauri",
      alternative: "Rivers grown from “kauri”",
      isMended: false,
      beyondElement: [],
    },
  ]);
});

test("an address, a word and a damaged link are the maps that they are of", () => {
  const rimu = {
    link: "seed=rimu&edition=1&land=valley",
    seed: "rimu",
    alternative: "Rivers grown from “rimu”",
    beyondElement: [],
  };
  expect(read("https://rivers.example/?seed=rimu&land=valley", "seed%3Drimu%26land%3Dvalley")).toEqual([
    { ...rimu, isMended: false },
    { ...rimu, isMended: true },
  ]);
  expect(read("Why?")[0]?.seed).toBe("Why?");
});

test("what the element would draw smaller is told with its limit, and the link stays as it is", () => {
  const [large, brownian, fits] = read(
    "country=usual&attractors=90000",
    "growth=brownian&sensitivity=8",
    "growth=brownian&sensitivity=16&attractors=30000",
  );
  expect(large).toEqual({
    link: "seed=kauri&edition=1&country=usual&attractors=90000",
    seed: "kauri",
    alternative: "Rivers grown from “kauri”",
    isMended: false,
    beyondElement: [expect.stringMatching(/^attractors: 90000 exceeds the element's limit of \d+$/)],
  });
  expect(brownian?.beyondElement).toEqual(["sensitivity: 8 is below the element's limit of 12"]);
  expect(fits?.beyondElement).toEqual([]);
});

test("a fault is told without a repair, which does not happen", () => {
  const long = "a: b ".repeat(20);
  const errors = read(
    "frog=1",
    "curl=3&sea=-1",
    "curl=1&curl=1",
    "edition=7",
    "land=x: y",
    `seed=${long}`,
    `seed=\u202e${long}`,
    `preset=x`,
    "seed=%00",
    `names=${Array.from({ length: 41 }, (_, i) => `${i}.a`).join("_")}`,
    `names=5.${"a".repeat(41)}`,
  ).map(({ error }) => error);
  expect(errors).toEqual([
    "there is no parameter 'frog'",
    "curl: 3 is not between 0 and 2; sea: -1 is not between 0 and 0.8",
    "'curl' is given more than once",
    "edition: 7 is unknown here, this program draws edition 1",
    expect.stringMatching(/^land: 'x: y' is not one of island, [a-z, ]*, drawn$/),
    "seed: the text has 99 characters, at most 64 are allowed",
    "seed: the text has 100 characters, at most 64 are allowed",
    expect.stringMatching(/^there is no preset 'x': choose from /),
    "seed: the text holds a character that cannot be shown",
    "names: there are 41 names, at most 40 are allowed",
    "names: the name of '5' has 41 characters, at most 40 are allowed",
  ]);
});
