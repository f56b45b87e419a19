import assert from "node:assert/strict";
import { mkdirSync, readFileSync, symlinkSync } from "node:fs";
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

const skip = await without("jekyll");

function site(name, changes) {
  const files = { "jekyll/site": "", "jekyll/river_seed.rb": "_plugins/river_seed.rb", "example.css": "example.css" };
  const source = copied(`jekyll-${name}`, files, changes);
  copyElement(join(source, "riverseed"));
  return source;
}

test("Jekyll: a blog under a path", { skip }, async () => {
  const source = site("blog");
  await build(source, "jekyll", ["build", "--quiet"]);
  await expectRivers(join(source, "_site"), { rivers: 2, picture: join(LOOKS, "jekyll.png") });
});

test("Jekyll: hostile words are text", { skip }, async () => {
  const source = site("hostile");
  write(source, "_data/words.json", JSON.stringify(HOSTILE));
  write(
    source,
    "index.md",
    "---\nlayout: post\ntitle: Hostile\n---\n{% for word in site.data.words %}\n{% river_seed word word %}\n{% endfor %}\n",
  );
  await placePictures(join(source, ".jekyll-cache/river-seed/riverseed"), HOSTILE.map(pngOf("sha256")));
  await build(source, "jekyll", ["build", "--quiet"]);
  await expectHarmless(join(source, "_site"), HOSTILE);
  assert.deepEqual(strangersIn(join(source, "_site")), []);
});

test("Jekyll: a hostile word is no option and no order of a shell where it is drawn", { skip }, async () => {
  const source = site("drawn");
  const words = ["-o hit.png", "$(touch hit) `touch hit`; touch hit"];
  write(
    source,
    "_data/words.json",
    JSON.stringify(words.map((word) => `seed=${encodeURIComponent(word)}&attractors=300`).concat("--help")),
  );
  write(
    source,
    "index.md",
    "---\nlayout: post\ntitle: Hostile\n---\n{% for word in site.data.words %}\n{% river_seed word %}\n{% endfor %}\n",
  );
  await build(source, "jekyll", ["build", "--quiet"]);
  await expectHarmless(join(source, "_site"), [...words, "--help"]);
  assert.deepEqual(strangersIn(join(source, "_site")), []);
});

test("Jekyll: a link's text alternative names its seed", { skip }, async () => {
  const source = site("links");
  write(source, "index.md", `---\n---\n${LINKS.map(([link]) => `{% river_seed "${link}" %}`).join("\n\n")}\n`);
  await placePictures(
    join(source, ".jekyll-cache/river-seed/riverseed"),
    LINKS.map(([link]) => pngOf("sha256")(link)),
  );
  await build(source, "jekyll", ["build", "--quiet"]);
  expectAlternatives(readFileSync(join(source, "_site/index.html"), "utf8"));
});

test("Jekyll: an address and a damaged link are read, and a map beyond the element's limits is a picture alone", {
  skip,
}, async () => {
  const source = site("given");
  const maps = ["https://rivers.example/?seed=rimu&land=valley", "seed=rimu&amp;land=valley", "attractors=24001"];
  write(source, "index.md", `---\n---\n${maps.map((map) => `{% river_seed "${map}" %}`).join("\n\n")}\n`);
  await placePictures(join(source, ".jekyll-cache/river-seed/riverseed"), maps.map(pngOf("sha256")));
  const { code, said } = await run(source, "jekyll", ["build"]);
  assert.equal(code, 0, said);
  const page = readFileSync(join(source, "_site/index.html"), "utf8");
  const recipe = "seed=rimu&amp;edition=1&amp;land=valley";
  assert.deepEqual(
    [...page.matchAll(/ recipe="([^"]*)"/g)].map(([, recipe]) => recipe),
    [recipe, recipe],
  );
  assert.equal(page.match(/<img /g).length, 3);
  assert.match(said, /river-seed: the link was damaged on its way, and has been mended/);
  assert.match(said, /river-seed: a picture without the element for "attractors=24001": attractors: 24001 exceeds/);
});

test("Jekyll: the element and the picture are of one edition, and a tag in a comment is no element", {
  skip,
}, async () => {
  const source = site("edition");
  const maps = ["kauri", "?seed=a&sea=0.8", "edition=1&seed=b"];
  const tags = maps.map((map) => `<!-- <river-seed> -->\n\n{% river_seed "${map}" %}`);
  write(source, "index.md", `---\n---\n${tags.join("\n\n")}\n`);
  await placePictures(join(source, ".jekyll-cache/river-seed/riverseed"), maps.map(pngOf("sha256")));
  await build(source, "jekyll", ["build", "--quiet"]);
  const page = readFileSync(join(source, "_site/index.html"), "utf8");
  assert.deepEqual(
    [...page.matchAll(/ recipe="([^"]*)"/g)].map(([, recipe]) => recipe),
    ["seed=kauri&amp;edition=1", "seed=a&amp;edition=1&amp;sea=0.8", "seed=b&amp;edition=1"],
  );
  assert.match(page, /width="16"/, "the pictures that are there are used");
});

const BAD = [
  ["an unknown parameter", '{% river_seed "seed=kauri&frog=1" %}', /river-seed: there is no parameter 'frog'/],
  [
    "a word that is too long",
    `{% river_seed "${LONG}" %}`,
    /river-seed: seed: the text has 200 characters, at most 64/,
  ],
  [
    "a hidden character",
    '{% river_seed "seed=a%00b" %}',
    /river-seed: seed: the text holds a character that cannot be shown/,
  ],
  ["no word", "{% river_seed %}", /river-seed: a word or a link is wanted/],
  [
    "an embed in an embed",
    '<river-seed>{% river_seed "seed=b&attractors=300" %}</river-seed>',
    /river-seed: a river-seed stands inside another: bad\.md/,
  ],
];

for (const [what, text, said] of BAD) {
  test(`Jekyll: ${what} stops the build and is named, with its page`, { skip }, async () => {
    const source = site("bad");
    write(source, "index.md", "---\n---\nGood");
    write(source, "bad.md", `---\n---\n${text}`);
    const heard = await run(source, "jekyll", ["build"]);
    assert.notEqual(heard.code, 0);
    assert.match(heard.said, said);
    assert.match(heard.said, /bad\.md/);
  });
}

test("Jekyll: a baseurl that is no path is named", { skip }, async () => {
  for (const base of ["blog", "//blog", "https://example.org/blog"]) {
    const source = site("baseurl", [["_config.yml", "baseurl: /blog", `baseurl: ${base}`]]);
    const { said } = await run(source, "jekyll", ["build"]);
    assert.ok(said.includes(`river-seed: baseurl is a path such as "/blog", not "${base}"`), said);
  }
});

test("Jekyll: an older Jekyll, an older or missing command and a missing element are named", { skip }, async () => {
  const older = site("older", [["_plugins/river_seed.rb", '"Jekyll" => "4.0"', '"Jekyll" => "99.0"']]);
  assert.match(
    (await run(older, "jekyll", ["build"])).said,
    /river-seed: Jekyll 99\.0 or newer is needed; this is 4\./,
  );
  const command = site("command", [["_plugins/river_seed.rb", '"riverseed" => "0.1.0"', '"riverseed" => "99.0.0"']]);
  assert.match(
    (await run(command, "jekyll", ["build"])).said,
    /river-seed: riverseed 99\.0\.0 or newer is needed; this is \d/,
  );
  const missing = site("missing");
  mkdirSync(join(missing, "bin"));
  symlinkSync("/dev/null", join(missing, "bin/riverseed"));
  const said = (await run(missing, "jekyll", ["build"], { PATH: join(missing, "bin"), HOME: missing })).said;
  assert.match(said, /river-seed: the command `riverseed` cannot be run/);
  const bare = site("bare", [["_plugins/river_seed.rb", "riverseed/river-seed.js", "elsewhere/river-seed.js"]]);
  assert.match(
    (await run(bare, "jekyll", ["build"])).said,
    /river-seed: the element's files are not in the folder riverseed/,
  );
});
