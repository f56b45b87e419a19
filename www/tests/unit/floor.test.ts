import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { browserslist } from "../../package.json";
import { floor } from "../../scripts/browsers.mjs";
import { newerThanFloor } from "../../scripts/newer.mjs";
import { advice } from "../../src/engine/advice.ts";
import { PageError } from "../../src/engine/errors.ts";

const { chrome, edge, firefox, safari, ios } = floor();
const IN_WORDS = `Chrome and Edge ${chrome}, Firefox ${firefox}, Safari ${safari}`;

test("the browser floor is quoted as it is stated", () => {
  expect(edge).toBe(chrome);
  expect(ios).toBe(safari);
  expect(advice(new PageError("wasm-unsupported", "")).text).toContain(IN_WORDS);
  for (const file of ["../README.md", "../docs/element.md", "../.cargo/config.toml"])
    expect(readFileSync(file, "utf8").replaceAll(/\n#? */g, " "), file).toContain(IN_WORDS);
});

test("style sheets are held to the same year as scripts", () => {
  const { available } = JSON.parse(readFileSync("biome.json", "utf8")).linter.rules.suspicious.useBaseline.options;
  expect(browserslist).toEqual([`baseline ${available}`]);
});

test("the lint finds what is newer, and nothing else", () => {
  const script = `
    const made: unknown[] = await Array.fromAsync([1]);
    export class Old { constructor(private readonly page: string) {} address = () => URL.parse(this.page) }
    new CloseWatcher();
    export const both = new Set([1]).union(new Set(made));
    document.startViewTransition?.(() => {});
    export const old = [Object.hasOwn({}, "a"), URL.canParse("a"), [1].toSorted(), structuredClone(1), made.at(-1)];
    class Iterator { static from(): void {} }
    Iterator.from();
    Promise.try(() => 1);
  `;
  expect(newerThanFloor(script).map(({ line, name }) => `${line}: ${name}`)).toEqual([
    "2: Array.fromAsync",
    "3: URL.parse",
    "4: CloseWatcher",
    "5: ….union",
    "10: Promise.try",
  ]);
});
