import { expect, test } from "vitest";
import { contents } from "../../build/docs/contents.ts";
import { sectionsOf } from "../../build/docs/sections.ts";
import { excerptOf, piecesOf } from "../../src/apps/docs/excerpt.ts";
import { Index, indexOf } from "../../src/apps/docs/index.ts";
import { countOf } from "../../src/apps/docs/results.ts";

const sections = contents().flatMap(({ articles }) => articles.flatMap(sectionsOf));
const index = new Index(indexOf(sections));
const addresses = (question: string) => index.find(question).map(({ address }) => address);

test("each section is found under its own address", () => {
  expect(new Set(sections.map(({ address }) => address)).size).toBe(sections.length);
});

test.each([
  ["bifurcation ratio", "algorithms.html#measures"],
  ["toBlob", "element.html#methods"],
  ["raster-size", "files.html#rasters"],
  ["Strahl", "glossary.html#rivers"],
  ["meandring", "algorithms.html#meandering"],
  ["content security policy", "hosting.html#the-element"],
  ["channel-area", "parameters.html#channel-area"],
  ["wasm-url", "element.html#wasm-url"],
  ["metres", "files.html#rasters"],
  ["csp", "hosting.html#the-element"],
  ["offline", "hosting.html#the-site"],
  ["how do I install it", "python.html#install"],
  ["license", "element.html#security"],
  ["GEOJSON", "files.html#geojson"],
])("“%s” leads to %s", (question, address) => {
  expect(addresses(question)).toContain(address);
});

test("a word in a heading counts more than one in the text", () => {
  expect(addresses("woods and hills")[0]).toBe("algorithms.html#woods-and-hills");
  expect(addresses("exit codes")[0]).toBe("command-line.html#exit-codes");
});

test("a word as it was typed counts more than one that is like it", () => {
  expect(addresses("react")[0]).toMatch(/framework/);
});

test("all words are wanted, and some of them if no section has all", () => {
  const both = index.find("oxbow shapefile");
  expect(both.length).toBeGreaterThan(0);
  for (const { text, heading } of index.find("oxbow neck")) expect(`${heading} ${text}`.toLowerCase()).toMatch(/neck/);
});

test("nothing is found for nothing, for signs alone, and for words that nobody wrote", () => {
  for (const question of ["", " ", "<>", "../", "\0", "‮", "qqqqzzzz"]) expect(index.find(question)).toEqual([]);
  expect(countOf([], "<b>")).toBe("Nothing found for “<b>”.");
});

test("an excerpt begins and ends with whole words, and shows the first hit", () => {
  const text = `${"far ".repeat(40)}the river bends here ${"and on ".repeat(60)}`;
  const pieces = excerptOf(["no hit", text], ["river"]);
  const said = pieces.map((piece) => piece.text).join("");
  expect(said).toMatch(/^… far .*the river bends here and on.* …$/);
  expect(said.length).toBeLessThan(170);
  expect(pieces.filter(({ isHit }) => isHit)).toEqual([{ text: "river", isHit: true }]);
});

test.each(["(", "[a", "\\", "a|b", "$", "<script>", "​", "'\""])(
  "no sign of a pattern breaks the marking of hits: %s",
  (word) => {
    const text = `before ${word} after`;
    expect(
      piecesOf(text, [word])
        .map((piece) => piece.text)
        .join(""),
    ).toBe(text);
    expect(piecesOf(text, [word]).some(({ isHit, text: hit }) => isHit && hit === word)).toBe(true);
  },
);
