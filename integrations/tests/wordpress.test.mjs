import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers, openPage, serve } from "./lib/browser.mjs";
import { HOSTILE } from "./lib/hostile.mjs";
import { expectAlternatives, LINKS } from "./lib/links.mjs";
import { build, copied, LOOKS, PACKAGE, run, SOURCES, theirs, without, write } from "./lib/workshop.mjs";

const { strFromU8, unzipSync } = theirs("fflate");
const sharp = theirs("sharp");
const { parameters } = await import(join(PACKAGE, "node.js"));

const skip = await without("php");
const STAND_IN = join(SOURCES, "tests/wordpress/wordpress.php");
const POST = `<p>A map needs its water first. This one comes from a single word, and the same word draws it again tomorrow.</p>
[river-seed map="kauri"]
<p>The second is a valley, from a link, as a block. Its text alternative is my own.</p>
<!-- wp:river-seed/map {"map":"seed=rimu&land=valley&attractors=3000","alt":"A valley whose river leaves to the south"} /-->
<p>Roads can wait until next week.</p>`;

/** Packs the plugin and returns the zip. */
async function packed(name) {
  const folder = copied(`wordpress-${name}`, { wordpress: "wordpress", "river-seed.mjs": "river-seed.mjs" });
  await build(folder, "node", ["wordpress/pack.mjs", PACKAGE, "river-seed.zip"]);
  return readFileSync(join(folder, "river-seed.zip"));
}

/** A site with the plugin installed from its zip. */
async function site(name) {
  const zip = unzipSync(await packed(name));
  const folder = copied(`wordpress-${name}`, { "example.css": "example.css" });
  for (const [path, bytes] of Object.entries(zip)) write(folder, `wp-content/plugins/${path}`, bytes);
  return folder;
}

/** Answers a request for a page, as WordPress does: the plugin is run on a post. */
async function render(folder, { post = POST, version = "6.5", may = [], media = {} }) {
  write(folder, "state.json", JSON.stringify({ post, version, may, media, address: "/blog/" }));
  const { code, said } = await run(folder, "php", [
    STAND_IN,
    join(folder, "wp-content/plugins/river-seed/river-seed.php"),
    "state.json",
  ]);
  assert.equal(code, 0, said);
  write(folder, "index.html", said);
  return said;
}

/** Looks at the page as an author, whose browser sends pictures; a media library takes them. */
async function lookAsAuthor(folder) {
  await render(folder, { may: ["upload_files", "edit_posts"] });
  const media = {};
  const site = await serve(folder, "/blog/", async ({ method, url, headers }, body) => {
    if (method !== "POST") return 404;
    assert.equal(url, "/blog/wp-json/wp/v2/media");
    assert.equal(headers["x-wp-nonce"], "nonce-wp_rest");
    const [, name] = /^attachment; filename="(river-seed-[0-9a-f]{16}\.(?:webp|png))"$/.exec(
      headers["content-disposition"],
    );
    write(folder, `uploads/${name}`, body);
    const { width, height, format } = await sharp(body).metadata();
    assert.equal(headers["content-type"], `image/${format}`);
    media[name.replace(/\.\w+$/, "")] = [`/blog/uploads/${name}`, width, height];
    return 201;
  });
  const { page, close } = await openPage();
  await page.goto(site.address);
  while (Object.keys(media).length < 2) await page.waitForResponse((answer) => answer.request().method() === "POST");
  await close();
  await site[Symbol.asyncDispose]();
  return media;
}

test("WordPress: a page under a path, whose pictures its author's browser has drawn", { skip }, async () => {
  const folder = await site("blog");
  const media = await lookAsAuthor(folder);
  for (const [address, width, height] of Object.values(media)) {
    assert.deepEqual([width, height], [1200, 750]);
    assert.ok(existsSync(join(folder, address.replace("/blog/", ""))));
  }
  const page = await render(folder, { media });
  assert.doesNotMatch(page, /data-poster|poster\.js/, "readers send no pictures");
  await expectRivers(folder, { rivers: 2, picture: join(LOOKS, "wordpress.png") });
});

test("WordPress: before there is a picture the place is kept, and an author's page asks for one", {
  skip,
}, async () => {
  const folder = await site("words");
  const reader = await render(folder, {});
  assert.match(
    reader,
    /aspect-ratio:1\.6;min-height:0;overflow:hidden"><p style="margin:0">Rivers grown from “kauri”<\/p><\/river-seed>/,
  );
  assert.doesNotMatch(reader, /data-poster|poster\.js/);
  assert.match(
    await render(folder, { post: '[river-seed map="seed=a&amp;aspect=2.5"]' }),
    /recipe="seed=a&amp;aspect=2\.5&amp;edition=1" style="display:block;aspect-ratio:2\.5;/,
  );
  assert.match(
    await render(folder, { post: '[river-seed map="seed=a&aspect=1;color:red"]' }),
    /style="display:block;aspect-ratio:1\.6;/,
  );
  await render(folder, {});
  await expectRivers(folder, { rivers: 2, pictures: 0 });
});

test("WordPress: a link's text alternative names its seed", { skip }, async () => {
  const folder = await site("links");
  const name = (map) =>
    `river-seed-${createHash("sha256").update(`${map} edition 1, 1200`).digest("hex").slice(0, 16)}`;
  const media = Object.fromEntries(LINKS.map(([link]) => [name(link), ["/blog/a.webp", 1200, 750]]));
  expectAlternatives(
    await render(folder, { post: LINKS.map(([link]) => `[river-seed map="${link}"]`).join("\n"), media }),
  );
});

test("WordPress: hostile words are text, as block and as shortcode", { skip }, async () => {
  const folder = await site("hostile");
  // As WordPress saves them: a block's attributes as JSON in a comment, a shortcode's with entities.
  const json = (word) =>
    JSON.stringify({ map: word, alt: word })
      .replaceAll("--", "\\u002d\\u002d")
      .replace(/[<>]/g, (sign) => (sign === "<" ? "\\u003c" : "\\u003e"));
  const entities = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#039;" };
  const block = (word) => `<!-- wp:river-seed/map ${json(word)} /-->`;
  const shortcode = (word) => `[river-seed map="${word.replace(/[&<>"']/g, (sign) => entities[sign])}" alt="x"]`;
  await render(folder, { post: HOSTILE.map(block).join("\n") });
  await expectHarmless(folder, HOSTILE, { own: "div.wp-block-river-seed-map" });
  await render(folder, { post: HOSTILE.map(shortcode).join("\n"), may: ["upload_files"] });
  const unslashed = HOSTILE.map((word) => word.replaceAll("\\", ""));
  await expectHarmless(folder, unslashed, { attributes: ["data-media", "data-nonce", "data-poster", "data-size"] });
});

test("WordPress: what is wrong is told to those who can mend it, and an older WordPress is named", {
  skip,
}, async () => {
  const folder = await site("bad");
  const may = ["edit_posts"];
  for (const [post, said] of [
    ["[river-seed]", /river-seed: a word or a link is wanted/],
    ['[river-seed map="a\0b"]', /river-seed: the map holds a character that cannot be shown/],
    ['[river-seed map="a"][river-seed map="b"][/river-seed]', /river-seed: a river-seed stands inside another/],
  ]) {
    assert.match(await render(folder, { post, may }), said);
    assert.doesNotMatch(await render(folder, { post }), /river-seed:|<river-seed/);
  }
  const older = await render(folder, { version: "6.4.3", may });
  assert.match(
    older,
    /river-seed: WordPress 6\.5 or newer is needed; this is 6\.4\.3\. Until then maps are pictures\./,
  );
  assert.doesNotMatch(older, /<script/);
});

test("WordPress: two packings are equal, and a zip holds what a site needs and no address of another", async () => {
  const zip = await packed("zip");
  assert.deepEqual(zip, await packed("zip"));
  const files = unzipSync(zip);
  for (const name of [
    "river-seed.php",
    "readme.txt",
    "poster.js",
    "block/block.json",
    "block/editor.js",
    "block/editor.asset.php",
    "element/river-seed.js",
    "LICENSE-MIT",
  ])
    assert.ok(`river-seed/${name}` in files, name);
  for (const name of ["river-seed.classic.js", "node.js"])
    assert.ok(!(`river-seed/element/${name}` in files), `${name}, which no page loads`);
  for (const name of ["river-seed.php", "poster.js", "block/editor.js"])
    assert.doesNotMatch(strFromU8(files[`river-seed/${name}`]), /https?:/);
});

test("WordPress: every file of the plugin names the version of the element that is in it", async () => {
  const files = unzipSync(await packed("version"));
  const text = (name) => strFromU8(files[`river-seed/${name}`]);
  const { version } = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8"));
  const block = JSON.parse(text("block/block.json"));
  assert.deepEqual(
    [
      /^ \* Version: (.*)$/m.exec(text("river-seed.php"))?.[1],
      /RIVER_SEED_VERSION = '(.*)'/.exec(text("river-seed.php"))?.[1],
      /'version' +=> '(.*)'/.exec(text("block/editor.asset.php"))?.[1],
      /^Stable tag: (.*)$/m.exec(text("readme.txt"))?.[1],
      block.version,
    ],
    Array(5).fill(version),
  );
  // As the published schema of block.json has it.
  assert.match(block.name, /^[a-z][a-z0-9-]*\/[a-z][a-z0-9-]*$/);
  assert.ok(text("block/editor.js").includes(`registerBlockType("${block.name}"`));
});

test("WordPress: the plugin names the edition that its element draws, unless the author does", { skip }, async () => {
  const folder = await site("edition");
  const post = ["a b", "edition=1&seed=b"].map((map) => `[river-seed map="${map}"]`).join("");
  const recipes = [...(await render(folder, { post })).matchAll(/ recipe="([^"]*)"/g)].map(([, recipe]) => recipe);
  const edition = parameters().find(({ key }) => key === "edition").default;
  assert.deepEqual(recipes, [`seed=a%20b&amp;edition=${edition}`, "edition=1&amp;seed=b"]);
});

test("WordPress: the block in the editor shows the map and changes it", async () => {
  const folder = await site("editor");
  write(folder, "index.html", readFileSync(join(SOURCES, "tests/wordpress/editor.html")));
  const site_ = await serve(folder, "/blog/");
  const { page, close } = await openPage();
  await page.goto(site_.address);
  await page.waitForFunction(() => globalThis.seen_.complete === 1);
  assert.equal(await page.locator("iframe").contentFrame().locator("river-seed").getAttribute("seed"), "kauri");
  await page.getByLabel("Word or link").fill("seed=rimu&attractors=300");
  await page.waitForFunction(() => globalThis.seen_.complete === 2);
  assert.equal(
    await page.locator("iframe").contentFrame().locator("river-seed").getAttribute("recipe"),
    "seed=rimu&attractors=300",
  );
  assert.deepEqual(site_.missing, []);
  await close();
  await site_[Symbol.asyncDispose]();
});
