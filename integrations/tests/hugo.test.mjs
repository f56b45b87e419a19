import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE, LONG } from "./lib/hostile.mjs";
import { expectAlternatives, LINKS } from "./lib/links.mjs";
import { build, copied, LOOKS, placePictures, run, strangersIn, webpOf, without, write } from "./lib/workshop.mjs";

const skip = await without("hugo", "version");

function site(name, changes) {
  const files = {
    "hugo/site": "",
    "hugo/river-seed.html": "layouts/shortcodes/river-seed.html",
    "hugo/river-seed-pictures.mjs": "river-seed-pictures.mjs",
    "river-seed.mjs": "river-seed.mjs",
    "example.css": "static/example.css",
  };
  return copied(`hugo-${name}`, files, changes);
}

test("Hugo: a blog under a path", { skip }, async () => {
  const source = site("blog");
  await build(source, "node", ["river-seed-pictures.mjs"]);
  await build(source, "hugo", ["--quiet"]);
  await expectRivers(join(source, "public"), { rivers: 2, picture: join(LOOKS, "hugo.png") });
});

test("Hugo: hostile words are text, in each spelling of a parameter", { skip }, async () => {
  const source = site("hostile");
  const words = HOSTILE.map((word) => (word.includes("`") ? `"${word.replaceAll('"', '\\"')}"` : `\`${word}\``));
  words.push('"say \\"hi\\""', "kauri");
  const texts = [...HOSTILE, 'say "hi"', "kauri"];
  write(
    source,
    "content/_index.md",
    `---\ntitle: Hostile\n---\n${words.map((word) => `{{< river-seed ${word} ${word} >}}`).join("\n\n")}\n`,
  );
  await placePictures(join(source, "assets/riverseed"), texts.map(webpOf));
  await build(source, "node", ["river-seed-pictures.mjs"]);
  await build(source, "hugo", ["--quiet"]);
  await expectHarmless(join(source, "public"), texts);
  assert.deepEqual(strangersIn(join(source, "public")), []);
  assert.deepEqual(strangersIn(join(source, "assets")), ["riverseed/maps.json"]);
});

test("Hugo: a link's text alternative names its seed", { skip }, async () => {
  const source = site("links");
  write(
    source,
    "content/_index.md",
    `---\n---\n${LINKS.map(([link]) => `{{< river-seed "${link}" >}}`).join("\n\n")}\n`,
  );
  await placePictures(
    join(source, "assets/riverseed"),
    LINKS.map(([link]) => webpOf(link)),
  );
  await build(source, "node", ["river-seed-pictures.mjs"]);
  await build(source, "hugo", ["--quiet"]);
  expectAlternatives(readFileSync(join(source, "public/index.html"), "utf8"));
});

test("Hugo: parameters may have names, and a map that is more than the element draws is a picture alone", {
  skip,
}, async () => {
  const source = site("named");
  const large = "attractors=24001&seed=moa";
  write(
    source,
    "content/_index.md",
    `\`<river-seed>\` is only text here.\n\n{{< river-seed alt="A, 'b'" map="kauri" >}}\n\n{{< river-seed map=\`${large}\` >}}\n`,
  );
  await placePictures(join(source, "assets/riverseed"), ["kauri", large].map(webpOf));
  const { code, said } = await run(source, "node", ["river-seed-pictures.mjs"]);
  assert.equal(code, 0, said);
  assert.match(
    said,
    /river-seed: a picture without the element for "attractors=24001&seed=moa": attractors: 24001 exceeds/,
  );
  await build(source, "hugo", ["--quiet"]);
  const page = readFileSync(join(source, "public/index.html"), "utf8");
  assert.equal(page.match(/<river-seed /g).length, 1);
  assert.match(
    page,
    /<river-seed recipe="seed=kauri&amp;edition=1" alt="A, &#39;b&#39;" [^>]*><img src="[^"]+" alt="A, &#39;b&#39;"/,
  );
  assert.match(page, /<img src="[^"]+" alt="Rivers grown from “moa”" width="16"[^>]*>(?!<\/river-seed>)/);
});

test("Hugo: the script names a content folder that is not there, and writes nothing then", { skip }, async () => {
  const source = site("elsewhere");
  const { code, said } = await run(source, "node", ["river-seed-pictures.mjs", "posts"]);
  assert.equal(code, 1);
  assert.match(
    said,
    /^river-seed: the content folder "posts" cannot be read \(ENOENT\)\. Run this in the site's folder/,
  );
  assert.equal(existsSync(join(source, "static/riverseed")), false);
});

const BAD = [
  [
    "an unknown parameter",
    '{{< river-seed "seed=kauri&frog=1" >}}',
    /river-seed: no map of "seed=kauri&frog=1": there is no parameter 'frog'/,
  ],
  [
    "a word that is too long",
    `{{< river-seed "${LONG}" >}}`,
    /river-seed: no map of "x+": seed: the text has 200 characters, at most 64/,
  ],
  ["no map among names", '{{< river-seed alt="A river" >}}', /river-seed: a word or a link is wanted/],
  [
    "an embed in an embed",
    '<river-seed>{{< river-seed "kauri" >}}</river-seed>',
    /river-seed: a river-seed stands inside another/,
  ],
];

for (const [what, text, said] of BAD) {
  test(`Hugo: ${what} is named before the build, with its page`, { skip }, async () => {
    const source = site("bad");
    write(source, "content/bad.md", `\n${text}`);
    await placePictures(
      join(source, "assets/riverseed"),
      ["kauri", "seed=rimu&land=valley&attractors=3000"].map(webpOf),
    );
    const heard = await run(source, "node", ["river-seed-pictures.mjs"]);
    assert.equal(heard.code, 1);
    assert.match(heard.said, said);
    assert.match(heard.said, /^content\/bad\.md/);
  });
}

test("Hugo: a picture that is not drawn yet, a shortcode in a shortcode, and an older Hugo stop the build and are named", {
  skip,
}, async () => {
  const source = site("undrawn");
  assert.match(
    (await run(source, "hugo", [])).said,
    /river-seed: no picture of "kauri" yet; run `node river-seed-pictures\.mjs` before hugo: .*_index\.md:7/,
  );
  write(source, "content/_index.md", "# A\n{{< river-seed >}}");
  assert.match(
    (await run(source, "hugo", [])).said,
    /river-seed: a word or a link is wanted, as "kauri": .*_index\.md:2/,
  );
  write(source, "content/_index.md", '# A\n{{< river-seed "kauri" >}}{{< river-seed "rimu" >}}{{< /river-seed >}}');
  assert.match((await run(source, "hugo", [])).said, /_index\.md:2.*"river-seed".*yet a closing tag was provided/);
  const older = site("older", [["layouts/shortcodes/river-seed.html", '"0.111.0"', '"99.0.0"']]);
  const heard = await run(older, "hugo", []);
  assert.notEqual(heard.code, 0);
  assert.match(heard.said, /river-seed: Hugo 99\.0\.0 or newer is needed; this is 0\.\d+/);
});
