import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { browserslist } from "../../package.json";
import { floor } from "../../scripts/browsers.mjs";
import { newerThanFloor } from "../../scripts/newer.mjs";
import { advice } from "../../src/engine/advice.ts";
import { PageError } from "../../src/engine/errors.ts";

const FLOOR = floor();
const BROWSERS = /\b(Chrome|Edge|Firefox|Safari) (?:and Edge )?(\d+(?:\.\d+)?)/g;

/** The versions of browsers that a text names, each once. */
function versions(text: string): Record<string, string[]> {
  const found: Record<string, string[]> = {};
  for (const [, name = "", version = ""] of text.replaceAll(/\s+(?:# )?/g, " ").matchAll(BROWSERS))
    found[name] = [...new Set([...(found[name] ?? []), version])];
  return found;
}

test("whoever names the versions of browsers names those of the floor", () => {
  const { chrome, edge, firefox, safari, ios } = FLOOR;
  expect([edge, ios]).toEqual([chrome, safari]);
  const texts = ["../README.md", "../docs/element.md", "../.cargo/config.toml"].map((file) =>
    readFileSync(file, "utf8"),
  );
  for (const text of [...texts, advice(new PageError("wasm-unsupported", "")).text])
    expect(versions(text)).toEqual({ Chrome: [chrome], Firefox: [firefox], Safari: [safari] });
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
