/** The first pages begin with something to paste, and what they give to paste is true. */

import { readFileSync } from "node:fs";
import { marked, type Tokens } from "marked";
import { parse } from "smol-toml";
import { expect, test } from "vitest";
import { pictures } from "../../build/docs/pictures.ts";
import { READERS, sourceOf } from "../../build/docs/readers.ts";
import { SOME_SITE } from "../../build/social.ts";
import { attributeOf } from "../../src/engine/attribute-names.ts";
import { table } from "../table.ts";
import { engine } from "../whole.ts";

const read = (file: string) => readFileSync(new URL(`../../../${file}`, import.meta.url), "utf8");
const PAGES = READERS.map((reader) => ({ ...reader, source: sourceOf(reader), text: read(sourceOf(reader)) }));
const shown = pictures();
const KEYS = new Set(table.parameters.map(({ key }) => key));

function codesIn(text: string): Tokens.Code[] {
  return marked.lexer(text).filter((token): token is Tokens.Code => token.type === "code");
}

const CODES = PAGES.flatMap(({ name, line, lang, text }) =>
  [...codesIn(text).map((code) => ({ lang: code.lang ?? "", text: code.text })), { lang, text: line }].map((code) => ({
    name,
    ...code,
  })),
);

function keyOf(attribute: string): string {
  return [...KEYS].find((key) => attributeOf(key) === attribute) ?? attribute;
}

/** All links to maps of a page: addresses of the site, recipes of commands and programs. */
function linksIn(text: string): string[] {
  const addresses = [...text.matchAll(/https:\/\/example\.org\/riverseed\/(?:embed\.html)?\?([^\s)"'<\\]+)/g)];
  const quoted = [...text.matchAll(/["`]((?:seed|land)=[^"`{]+)["`]/g)];
  return [...addresses, ...quoted].map(([, link = ""]) => link.replaceAll("&amp;", "&").replace(/^view=six$/, ""));
}

test.each(PAGES)("$name: after the title one sentence or two, and then what to paste", ({ text }) => {
  const [title, lead, code] = marked.lexer(text).filter(({ type }) => type !== "space");
  expect([title?.type, lead?.type, code?.type]).toEqual(["heading", "paragraph", "code"]);
  expect(lead?.raw.length).toBeLessThan(190);
});

test.each(PAGES)("$name: three to eight things that come next, and most lead on", ({ text }) => {
  const parts = text.split(/^## /m).slice(1);
  expect(parts.length).toBeGreaterThanOrEqual(3);
  expect(parts.length).toBeLessThanOrEqual(8);
  expect(parts.filter((part) => part.includes("](")).length).toBeGreaterThan(parts.length / 2);
});

test("every link to a map is read without a notice", () => {
  const links = PAGES.flatMap(({ name, text, line }) => linksIn(`${text}\n${line}`).map((link) => ({ name, link })));
  expect(links.length).toBeGreaterThan(20);
  for (const { name, link } of links) expect(engine.readLink(link).notices, `${name}: ${link}`).toEqual([]);
});

/** The settings that decide where rivers run. */
function riversOf(link: string): Map<string, string> {
  const looks = ["style", "labels", "cartouche", "woods", "hills"];
  return new Map(engine.readLink(link).values.filter(([key]) => !looks.includes(key)));
}

test.each(PAGES.filter(({ map }) => map))("$name: the picture is of the map that is pasted", ({ name, text }) => {
  const [first] = codesIn(text);
  const link = linksIn(first?.text ?? "")[0] ?? "";
  expect(riversOf(link)).toEqual(riversOf(shown.get(name)?.link ?? ""));
});

test("elements to paste have attributes that make a whole map, and the same as their links lead to", () => {
  const elements = CODES.flatMap(({ text }) =>
    [...text.matchAll(/<river-seed ([^>]*)>/g)].map(([, all = ""]) => ({ all, text })),
  );
  expect(elements.length).toBeGreaterThan(2);
  for (const { all, text } of elements) {
    const attributes = [...all.matchAll(/([\w-]+)="([^"]*)"/g)].filter(([, name]) => name !== "style");
    const link = attributes.map(([, name = "", value = ""]) => `${keyOf(name)}=${encodeURIComponent(value)}`).join("&");
    expect(engine.readLink(link, { widget: true }).notices, all).toEqual([]);
    for (const other of linksIn(text)) expect(riversOf(other)).toEqual(riversOf(link));
  }
});

test("commands are those of the command line, with options that it has", () => {
  const told = read("docs/command-line.md") + read("docs/batch.md");
  const commands = [...read("docs/command-line.md").matchAll(/^\| `(\w+)` \|/gm)].map(([, command = ""]) => command);
  const lines = CODES.flatMap(({ lang, text }) => (lang === "sh" ? text.split("\n") : []));
  const calls = lines.filter((line) => line.startsWith("riverseed "));
  expect(calls.length).toBeGreaterThan(4);
  for (const call of calls) {
    expect(commands, call).toContain(call.split(" ")[1]);
    for (const [, option = ""] of call.matchAll(/ --([a-z-]+)/g))
      expect(KEYS.has(option) || told.includes(`\`--${option}`), `${call}: --${option}`).toBe(true);
    for (const [, ending = ""] of call.matchAll(/ -o "?[\w/{}]+(\.[a-z.]+)/g))
      expect(told, call).toContain(`\`${ending}\``);
  }
});

/** The first cells of the table under a heading of the page for Rust. */
function namesUnder(heading: string): string[] {
  const [, part = ""] = read("docs/for/rust.md").split(`## ${heading}\n`);
  const names = [...part.replace(/^## [\s\S]*/m, "").matchAll(/^\| `(\w+)` \|/gm)].map(([, name = ""]) => name);
  expect(names.length, heading).toBeGreaterThan(2);
  return names;
}

test("the Rust program is the one of the README, which is compiled and run with its tests", () => {
  const [program] = CODES.filter(({ lang }) => lang === "rust");
  expect(codesIn(read("README.md")).find(({ lang }) => lang === "rust")?.text).toBe(program?.text);
  for (const name of namesUnder("Programs to begin with"))
    expect(read(`examples/${name}.rs`), name).toContain("fn main()");
  const { features } = parse(read("Cargo.toml")) as { features: Record<string, string[]> };
  expect(Object.keys(features)).toEqual(expect.arrayContaining(namesUnder("Take what you need")));
});

test("programs in JavaScript import what the npm package has", () => {
  const { exports } = JSON.parse(read("www/package/package.json")) as { exports: Record<string, unknown> };
  const programs = CODES.filter(({ lang }) => lang === "js")
    .map(({ text }) => text)
    .join("\n");
  const imported = [...programs.matchAll(/"riverseed(\/[\w-]+)?"/g)].map(([, path = ""]) => `.${path}`);
  expect(imported.length).toBeGreaterThan(1);
  for (const path of imported) expect(Object.keys(exports)).toContain(path);
});

test("the package to install has the version of the crate", () => {
  const { package: crate } = parse(read("Cargo.toml")) as { package: { version: string } };
  const named = CODES.flatMap(({ text }) =>
    [...text.matchAll(/riverseed-([\d.]+)\.tgz/g)].map(([, version]) => version),
  );
  expect(new Set(named)).toEqual(new Set([crate.version]));
});

test("programs in Python give parameters that there are", () => {
  const programs = CODES.filter(({ lang }) => lang === "python")
    .map(({ text }) => text)
    .join("\n");
  const keywords = [...programs.matchAll(/grow\(([^)]*)\)/g)].flatMap(([, call = ""]) => [
    ...call.matchAll(/, (\w+)=/g),
  ]);
  expect(keywords.length).toBeGreaterThan(3);
  for (const [, keyword = ""] of keywords) expect(KEYS, keyword).toContain(keyword.replaceAll("_", "-"));
});

test("addresses are those of the site, and nothing is fetched from others", () => {
  for (const { name, text } of CODES)
    for (const [address] of text.matchAll(/https?:\/\/[^\s"']+/g))
      expect(address.startsWith(SOME_SITE), `${name}: ${address}`).toBe(true);
});

test("README and the element's page begin with the same snippet", () => {
  const snippets = ["README.md", "docs/element.md"].map((file) =>
    codesIn(read(file)).find(({ lang }) => lang === "html"),
  );
  expect(snippets[0]?.text).toBe(snippets[1]?.text);
});

test("every block of README and the guides is of a language that a test runs, or an address, which is read", () => {
  // sh: crates/cli/tests/documents.rs. rust: the tests of the crate. python: python/tests/test_package.py. js:
  // tests/package/guide.test.ts and tests/e2e/widget/guides.spec.ts, as html. text: addresses, which are read above.
  const RUN = ["html", "js", "python", "rust", "sh", "text"];
  const all = [...codesIn(read("README.md")), ...PAGES.flatMap(({ text }) => codesIn(text))];
  expect(all.length).toBeGreaterThan(15);
  for (const { lang = "", text } of all) {
    expect(RUN, text).toContain(lang);
    if (lang === "text") expect(linksIn(text), text).toHaveLength(1);
  }
});
