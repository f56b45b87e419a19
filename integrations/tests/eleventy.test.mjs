import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE, LONG } from "./lib/hostile.mjs";
import { expectAlternatives, LINKS } from "./lib/links.mjs";
import { build, copied, LOOKS, placePictures, run, strangersIn, webpOf, write } from "./lib/workshop.mjs";

const PREFIX = ["--pathprefix=blog"];

function site(name, changes) {
  const files = { eleventy: "", "river-seed.mjs": "river-seed.mjs", "example.css": "site/example.css" };
  const source = join(copied(`eleventy-${name}`, files, changes), "site");
  return { source, built: join(source, "_site") };
}

test("Eleventy: a blog under a path", async () => {
  const { source, built } = site("blog");
  await build(source, "eleventy", PREFIX);
  await expectRivers(built, { rivers: 2, picture: join(LOOKS, "eleventy.png") });
});

test("Eleventy: hostile words are text", async () => {
  const { source, built } = site("hostile");
  // Liquid has no escapes, so words come from data, as they would from a stranger's file.
  write(source, "_data/words.json", JSON.stringify(HOSTILE));
  write(
    source,
    "index.md",
    "---\nlayout: post.liquid\ntitle: Hostile\n---\n{% for word in words %}\n{% riverSeed word, word %}\n{% endfor %}\n",
  );
  await placePictures(join(built, "riverseed"), HOSTILE.map(webpOf));
  await build(source, "eleventy", PREFIX);
  await expectHarmless(built, HOSTILE);
  assert.deepEqual(strangersIn(built), []);
});

test("Eleventy: a link's text alternative names its seed", async () => {
  const { source, built } = site("links");
  write(source, "index.md", LINKS.map(([link]) => `{% riverSeed "${link}" %}`).join("\n\n"));
  await placePictures(
    join(built, "riverseed"),
    LINKS.map(([link]) => webpOf(link)),
  );
  await build(source, "eleventy", PREFIX);
  expectAlternatives(readFileSync(join(built, "index.html"), "utf8"));
});

const BAD = [
  [
    "an unknown parameter",
    '{% riverSeed "seed=kauri&frog=1" %}',
    /river-seed: no map of "seed=kauri&frog=1": there is no parameter 'frog'/,
  ],
  [
    "a word that is too long",
    `{% riverSeed "${LONG}" %}`,
    /river-seed: no map of "x+": seed: the text has 200 characters, at most 64/,
  ],
  [
    "a hidden character",
    '{% riverSeed "seed=a%00b" %}',
    /river-seed: no map of "seed=a%00b": seed: the text holds a character that cannot be shown/,
  ],
  ["no word", "{% riverSeed %}", /river-seed: a word or a link is wanted/],
  [
    "an embed in an embed",
    '<river-seed seed="a">{% riverSeed "seed=b&attractors=300" %}</river-seed>',
    /river-seed: a river-seed stands inside another: \.\/_site\/bad/,
  ],
];

for (const [what, text, said] of BAD) {
  test(`Eleventy: ${what} stops the build and is named, with its page`, async () => {
    const { source } = site("bad");
    write(source, "index.md", "# Good");
    write(source, "bad.md", text);
    const heard = await run(source, "eleventy", PREFIX);
    assert.notEqual(heard.code, 0);
    assert.match(heard.said, said);
    assert.match(heard.said, /\/bad[./]/);
  });
}

test("Eleventy: a base that is no address, and an older Eleventy, are named", async () => {
  const plugin = "config.addPlugin(riverSeed";
  const base = site("base", [["site/eleventy.config.mjs", plugin, `${plugin}, { base: "blog" }`]]);
  assert.match((await run(base.source, "eleventy", [])).said, /river-seed: the site's base is a path .*, not "blog"/);
  const older = site("older", [["eleventy.mjs", '"3.0"', '"99.0"']]);
  assert.match(
    (await run(older.source, "eleventy", [])).said,
    /river-seed: Eleventy 99.0 or newer is needed; this is 3\./,
  );
});
