import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE, LONG } from "./lib/hostile.mjs";
import { copied, LOOKS, placePictures, run, strangersIn, webpOf, write } from "./lib/workshop.mjs";

const site = (name) =>
  copied(`ghost-${name}`, {
    "ghost/card.mjs": "card.mjs",
    "river-seed.mjs": "river-seed.mjs",
    "example.css": "example.css",
  });
const card = (folder, ...words) => run(folder, "node", ["card.mjs", ...words]);

/** Writes a post as Ghost does, which takes an HTML card as it is. */
function post(folder, cards) {
  const content = cards
    .map((one) => `<p>A map needs its water first.</p>\n<!--kg-card-begin: html-->\n${one}<!--kg-card-end: html-->`)
    .join("\n");
  write(
    folder,
    "index.html",
    `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Thursday maps</title>
<link rel="stylesheet" href="example.css"><link rel="icon" href="data:,"></head><body><header>Thursday maps, by Ghost</header><main><h1>One river</h1>${content}</main></body></html>`,
  );
}

test("Ghost: a card under a path", async () => {
  const folder = site("blog");
  const { said } = await card(folder, "seed=rimu&land=valley&attractors=3000", "--site", "/blog/", "--alt", "A valley");
  assert.ok(said.trim().split("\n").length <= 5, "what is pasted has five lines at most");
  post(folder, [said]);
  await expectRivers(folder, { rivers: 1, picture: join(LOOKS, "ghost.png") });
});

test("Ghost: hostile words are text", async () => {
  const folder = site("hostile");
  await placePictures(join(folder, "riverseed"), HOSTILE.map(webpOf));
  const cards = [];
  for (const word of HOSTILE) cards.push((await card(folder, "--site=/blog/", `--alt=${word}`, "--", word)).said);
  post(folder, cards);
  await expectHarmless(folder, HOSTILE);
  assert.deepEqual(strangersIn(folder), ["card.mjs", "river-seed.mjs"]);
});

test("Ghost: what is wrong is named", async () => {
  const folder = site("bad");
  for (const [words, said] of [
    [["seed=kauri&frog=1"], /^river-seed: no map of "seed=kauri&frog=1": there is no parameter 'frog'/m],
    [[LONG], /^river-seed: no map of "x+": seed: the text has 200 characters, at most 64/m],
    [[], /^river-seed: a word or a link is wanted/m],
    [["kauri", "--site", "blog"], /^river-seed: the site's base is a path .*, not "blog"$/m],
  ]) {
    const heard = await card(folder, ...words);
    assert.equal(heard.code, 1);
    assert.match(heard.said, said);
  }
});
