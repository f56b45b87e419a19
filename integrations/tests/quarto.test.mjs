import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE, LONG } from "./lib/hostile.mjs";
import { expectAlternatives, LINKS } from "./lib/links.mjs";
import {
  build,
  copied,
  copyElement,
  LOOKS,
  placePictures,
  pngOf,
  run,
  strangersIn,
  without,
  write,
} from "./lib/workshop.mjs";

// Quarto itself cannot be had from Debian or npm. Its shortcodes are Lua that Pandoc runs.
const skip = await without("pandoc");
const PANDOC = ["--lua-filter", "stand-in.lua", "--template", "page.html", "post.md", "-o"];
const SHORTCODE = /^\{\{< river-seed (?:"([^"]*)"|(\S+))(?: alt="([^"]*)")? >\}\}$/gm;

/** Writes a post with calls of the shortcode, each of them a map and a text alternative. */
function post(folder, text, calls) {
  const lua = (word) =>
    word === undefined
      ? "nil"
      : `"${[...Buffer.from(word)].map((byte) => `\\${String(byte).padStart(3, "0")}`).join("")}"`;
  write(folder, "calls.lua", `return { ${calls.map((call) => `{ ${call.map(lua).join(", ")} }`).join(", ")} }`);
  write(folder, "post.md", text);
}

function site(name) {
  const files = { quarto: "", "tests/quarto": "", "example.css": "example.css" };
  const folder = copied(`quarto-${name}`, files);
  copyElement(join(folder, "riverseed"));
  return folder;
}

const allOf = (calls) => `# Hostile\n\n${calls.map((_, i) => `SHORTCODE ${i + 1}`).join("\n\n")}\n`;

test("Quarto: the example, in Pandoc", { skip }, async () => {
  const folder = site("blog");
  const calls = [];
  const text = readFileSync(join(folder, "example.qmd"), "utf8").replace(
    SHORTCODE,
    (_, quoted, bare, alt) => `SHORTCODE ${calls.push([quoted ?? bare, alt])}`,
  );
  assert.equal(calls.length, 2);
  post(folder, text.replace(/^---\ntitle: (.*)\n---/, "# $1"), calls);
  await build(folder, "pandoc", [...PANDOC, "index.html"]);
  await expectRivers(folder, { rivers: 2, picture: join(LOOKS, "quarto.png") });
  // A printed page has the picture.
  await build(folder, "pandoc", [...PANDOC.filter((word) => !/template|page/.test(word)), "post.tex"]);
  assert.match(
    readFileSync(join(folder, "post.tex"), "utf8"),
    /\\includegraphics\{\.\/riverseed\/river-seed-[0-9a-f]{16}\.png\}/,
  );
});

test("Quarto: hostile words are text", { skip }, async () => {
  const folder = site("hostile");
  const calls = HOSTILE.map((word) => [word, word]);
  post(folder, allOf(calls), calls);
  await placePictures(join(folder, "riverseed"), HOSTILE.map(pngOf("sha1")));
  await build(folder, "pandoc", [...PANDOC, "index.html"]);
  await expectHarmless(folder, HOSTILE, { pictures: /^\.\/riverseed\/river-seed-[0-9a-f]{16}\.png$/ });
  assert.deepEqual(
    strangersIn(join(folder, "riverseed")).filter(
      (file) => !/^([\w.-]+\.(js|wasm)|river-seed-[0-9a-f]{16}\.png)$/.test(file),
    ),
    [],
  );
});

test("Quarto: a link's text alternative names its seed", { skip }, async () => {
  const folder = site("links");
  const maps = LINKS.map(([link]) => link);
  post(
    folder,
    allOf(maps),
    maps.map((map) => [map]),
  );
  await placePictures(join(folder, "riverseed"), maps.map(pngOf("sha1")));
  await build(folder, "pandoc", [...PANDOC, "index.html"]);
  expectAlternatives(readFileSync(join(folder, "index.html"), "utf8"));
});

test("Quarto: an address and a damaged link are read, and a map beyond the element's limits is a picture alone", {
  skip,
}, async () => {
  const folder = site("given");
  const maps = ["https://rivers.example/?seed=rimu&land=valley", "seed=rimu&amp;land=valley", "attractors=24001"];
  post(
    folder,
    allOf(maps),
    maps.map((map) => [map]),
  );
  await placePictures(join(folder, "riverseed"), maps.map(pngOf("sha1")));
  const { code, said } = await run(folder, "pandoc", [...PANDOC, "index.html"]);
  assert.equal(code, 0, said);
  const page = readFileSync(join(folder, "index.html"), "utf8");
  const recipe = "seed=rimu&#38;edition=1&#38;land=valley";
  assert.deepEqual(
    [...page.matchAll(/ recipe="([^"]*)"/g)].map(([, recipe]) => recipe),
    [recipe, recipe],
  );
  assert.equal(page.match(/<img /g).length, 3);
  assert.match(said, /riverseed: the link was damaged on its way, and has been mended/);
  assert.match(said, /river-seed: a picture without the element for "attractors=24001": attractors: 24001 exceeds/);
});

test("Quarto: the element and the picture are of one edition", { skip }, async () => {
  const folder = site("edition");
  const maps = ["kauri", "?seed=a&sea=0.8", "edition=1&seed=b"];
  post(
    folder,
    allOf(maps),
    maps.map((map) => [map]),
  );
  await placePictures(join(folder, "riverseed"), maps.map(pngOf("sha1")));
  await build(folder, "pandoc", [...PANDOC, "index.html"]);
  const page = readFileSync(join(folder, "index.html"), "utf8");
  assert.deepEqual(
    [...page.matchAll(/ recipe="([^"]*)"/g)].map(([, recipe]) => recipe.replaceAll("&#38;", "&")),
    ["seed=kauri&edition=1", "seed=a&edition=1&sea=0.8", "seed=b&edition=1"],
  );
  assert.match(page, /width="16"/, "the pictures that are there are used");
});

test("Quarto: what is wrong stops the build and is named", { skip }, async () => {
  const folder = site("bad");
  for (const [call, said, environment] of [
    [
      ["seed=kauri&frog=1"],
      /riverseed: there is no parameter 'frog'[^]*river-seed: no map of "seed=kauri&frog=1": see above/,
    ],
    [[LONG], /riverseed: seed: the text has 200 characters, at most 64[^]*river-seed: no map of "x+": see above/],
    [["a\0b"], /river-seed: the map holds a character that cannot be shown/],
    [[], /river-seed: a word or a link is wanted/],
    [["kauri"], /river-seed: the command `riverseed` cannot be run/, { PATH: folder }],
  ]) {
    post(folder, allOf([call]), [call]);
    const heard = await run(folder, "pandoc", [...PANDOC, "index.html"], environment);
    assert.notEqual(heard.code, 0);
    assert.match(heard.said, said);
  }
});
