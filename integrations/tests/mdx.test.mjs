import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE, LONG } from "./lib/hostile.mjs";
import { build, copied, LOOKS, placePictures, run, strangersIn, webpOf, write } from "./lib/workshop.mjs";

const BUILD = ["build.mjs", "post.mdx", "public/index.html"];

function site(name) {
  const files = { mdx: "", "river-seed.mjs": "river-seed.mjs", "example.css": "site/public/example.css" };
  const source = join(copied(`mdx-${name}`, files), "site");
  return { source, built: join(source, "public") };
}

test("MDX: a post under a path", async () => {
  const { source, built } = site("blog");
  await build(source, "node", BUILD);
  await expectRivers(built, { rivers: 2, picture: join(LOOKS, "mdx.png") });
});

test("MDX: hostile words are text", async () => {
  const { source, built } = site("hostile");
  write(
    source,
    "post.mdx",
    `# Hostile\n\n${HOSTILE.map((word) => `<RiverSeed map={${JSON.stringify(word)}} alt={${JSON.stringify(word)}} />`).join("\n\n")}\n`,
  );
  await placePictures(join(built, "riverseed"), HOSTILE.map(webpOf));
  await build(source, "node", BUILD);
  await expectHarmless(built, HOSTILE);
  assert.deepEqual(strangersIn(built), []);
});

test("MDX: a map that is more than the element draws is a picture alone", async () => {
  const { source, built } = site("large");
  write(source, "post.mdx", '# Large\n\n<RiverSeed map="seed=moa&attractors=24001" />\n');
  await placePictures(join(built, "riverseed"), [webpOf("seed=moa&attractors=24001")]);
  const { code, said } = await run(source, "node", BUILD);
  assert.equal(code, 0, said);
  assert.match(said, /river-seed: a picture without the element for "seed=moa&attractors=24001"/);
  const page = readFileSync(join(built, "index.html"), "utf8");
  assert.match(page, /<img [^>]*alt="Rivers grown from “moa”"/);
  assert.doesNotMatch(page, /<river-seed/);
});

for (const [what, text, said] of [
  [
    "an unknown parameter",
    '<RiverSeed map="seed=kauri&frog=1" />',
    /river-seed: no map of "seed=kauri&frog=1": there is no parameter 'frog'/,
  ],
  [
    "a word that is too long",
    `<RiverSeed map="${LONG}" />`,
    /river-seed: no map of "x+": seed: the text has 200 characters, at most 64/,
  ],
  ["no word", "<RiverSeed />", /river-seed: a word or a link is wanted/],
  [
    "a word that is known too late",
    "<RiverSeed map={props.word} />",
    /river-seed: "map" is a literal text, .*; got \{props\.word\}/,
  ],
  [
    "an embed in an embed",
    '<RiverSeed map="kauri"><RiverSeed map="rimu" /></RiverSeed>',
    /river-seed: a river-seed stands inside another/,
  ],
  [
    "an embed in an element",
    '<river-seed seed="a">\n<RiverSeed map="rimu" />\n</river-seed>',
    /river-seed: a river-seed stands inside another/,
  ],
]) {
  test(`MDX: ${what} stops the build and is named, with its place`, async () => {
    const { source } = site("bad");
    write(source, "post.mdx", `# Bad\n\n${text}\n`);
    const heard = await run(source, "node", BUILD);
    assert.equal(heard.code, 1);
    assert.match(heard.said, said);
    assert.match(heard.said, /post\.mdx:[345]:/);
  });
}

test("MDX: a base that is no address is named", async () => {
  const { source } = site("base");
  assert.match(
    (await run(source, "node", [...BUILD, "blog"])).said,
    /river-seed: the site's base is a path .*, not "blog"/,
  );
});
