// The file that the integrations with npm share, by itself.

import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { mock, test } from "node:test";
import { copied, placePictures, webpOf, write } from "./lib/workshop.mjs";

const SMALL = "seed=moa&edition=1&attractors=300";

/** Copies the file to a folder, and loads it from there. */
async function shared(name) {
  const folder = copied(`shared-${name}`, { "river-seed.mjs": "river-seed.mjs" });
  return { folder, ...(await import(join(folder, "river-seed.mjs"))) };
}

/** Embeds a map whose picture is there already; the HTML, and what the author is told. */
async function embedded({ folder, embed, html }, map) {
  await placePictures(folder, [webpOf(map)]);
  const warn = mock.method(console, "warn", () => {});
  try {
    const page = html(await embed(map, { folder, base: "/" }));
    return { page, said: warn.mock.calls.map(({ arguments: words }) => words.join(" ")) };
  } finally {
    warn.mock.restore();
  }
}

test("the element gets the canonical link, whose edition an upgrade does not change", async () => {
  const files = await shared("link");
  for (const [map, link] of [
    ["kauri", "seed=kauri&#38;edition=1"],
    ["?sea=0.80&seed=a", "seed=a&#38;edition=1&#38;sea=0.8"],
    ["seed=a&style=atlas", "seed=a&#38;edition=1&#38;style=atlas"],
  ]) {
    const { page, said } = await embedded(files, map);
    assert.ok(page.includes(`<river-seed recipe="${link}"`), page);
    assert.deepEqual(said, []);
  }
  const names = ["seed=a&edition=1", "seed=a&edition=2"].map(files.fileOf);
  assert.notEqual(names[0], names[1], "another edition has another picture");
});

test("a map that is more than the element draws is a picture alone, and the author is told once why", async () => {
  const files = await shared("large");
  const large = "seed=kauri&country=usual&attractors=24001";
  const { page, said } = await embedded(files, large);
  assert.match(page, /^<img src="\/river-seed-[0-9a-f]{16}\.webp" alt="Rivers grown from “kauri”" width="16"[^>]*>$/);
  assert.deepEqual(said, [
    `river-seed: a picture without the element for "${large}": attractors: 24001 exceeds the element's limit of 24000`,
  ]);
  assert.deepEqual((await embedded(files, large)).said, []);
  assert.match((await embedded(files, "country=usual&attractors=24000")).page, /<river-seed/);
});

test("an error names the fault, and no repair, since there is none", async () => {
  const { readMap } = await shared("faults");
  assert.throws(() => readMap("frog=1&sea=7"), {
    message: `river-seed: no map of "frog=1&sea=7": there is no parameter 'frog'; sea: 7 is not between 0 and 0.8`,
  });
});

test("only elements that stand inside one another are refused, not tags that a reader cannot see", async () => {
  const { refuseNested } = await shared("nested");
  const one = '<river-seed seed="a"></river-seed>';
  for (const page of [
    `${one}${one}`,
    `<!-- <river-seed> -->${one}`,
    `<script>"<river-seed>"</script>${one}`,
    `<style>/* <river-seed> */</style>${one}`,
  ])
    refuseNested(page);
  for (const page of [`<river-seed>${one}</river-seed>`, `</river-seed><river-seed>${one}</river-seed>`])
    assert.throws(() => refuseNested(page, "page.html"), /a river-seed stands inside another: page\.html/);
});

test("a picture that was deleted is drawn again, and so is one whose drawing failed", async () => {
  const { folder, drawOnce, fileOf } = await shared("again");
  const pictures = join(folder, "pictures");
  writeFileSync(pictures, "a file where the folder should be");
  await assert.rejects(drawOnce(SMALL, pictures), /EEXIST|ENOTDIR/);
  rmSync(pictures);
  for (let i = 0; i < 2; i++) {
    assert.equal((await drawOnce(SMALL, pictures)).width, 1200);
    assert.ok(existsSync(join(pictures, fileOf(SMALL))));
    rmSync(join(pictures, fileOf(SMALL)));
  }
});

test("what another process is still drawing is left alone", async () => {
  const { folder, drawOnce, fileOf } = await shared("two");
  const pictures = join(folder, "pictures");
  write(pictures, `${fileOf(SMALL)}.new`, "unfinished");
  await drawOnce(SMALL, pictures);
  assert.equal(readFileSync(join(pictures, `${fileOf(SMALL)}.new`), "utf8"), "unfinished");
  assert.deepEqual(readdirSync(pictures), [fileOf(SMALL), `${fileOf(SMALL)}.new`]);
});
