import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers, openPage, serve } from "./lib/browser.mjs";
import { HOSTILE } from "./lib/hostile.mjs";
import { build, copied, LOOKS, PACKAGE, run, SOURCES, theirs, without, write } from "./lib/workshop.mjs";

const { strFromU8, unzipSync } = theirs("fflate");
const sharp = theirs("sharp");

const WORDPRESS = process.env["RIVERSEED_WORDPRESS"] ?? "";
const skip =
  (await without("php")) || (!existsSync(join(WORDPRESS, "wp-includes")) && "WordPress is not on this machine");
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

/** Answers a request as WordPress does, in this state of a site. */
async function answer(folder, state) {
  write(folder, "state.json", JSON.stringify({ version: "6.5", may: [], media: {}, address: "/blog/", ...state }));
  const plugin = join(folder, "wp-content/plugins/river-seed/river-seed.php");
  const { code, said } = await run(folder, "php", [STAND_IN, WORDPRESS, plugin, "state.json"]);
  assert.equal(code, 0, said);
  assert.doesNotMatch(said, /(Warning|Notice|Deprecated|Fatal error): .* on line/, said);
  return said;
}

/** Answers a request for a page: the plugin is run on a post. */
async function render(folder, { post = POST, ...state }) {
  const said = await answer(folder, { post, ...state });
  write(folder, "index.html", said);
  return said;
}

/** What authors may do who see their own post. */
const AUTHOR = ["upload_files", "edit_posts", "edit_post 7"];

/** The name of a map's picture. */
const nameOf = (map) =>
  `river-seed-${createHash("sha256").update(`${map} edition 1, 1200`).digest("hex").slice(0, 16)}`;

/** Looks at the page as an author, whose browser sends pictures; a media library takes them. */
async function lookAsAuthor(folder) {
  await render(folder, { may: AUTHOR });
  const media = {};
  let atOnce = 0;
  const site = await serve(folder, "/blog/", async ({ method, url, headers }, body) => {
    if (method !== "POST") return 404;
    assert.equal(++atOnce, 1, "one at a time");
    const { pathname, searchParams } = new URL(url, "http://localhost");
    assert.equal(pathname, "/blog/wp-json/wp/v2/media");
    assert.equal(searchParams.get("post"), "7");
    assert.equal(headers["x-wp-nonce"], "nonce-wp_rest");
    const [, name] = /^attachment; filename="(river-seed-[0-9a-f]{16}\.(?:webp|png))"$/.exec(
      headers["content-disposition"],
    );
    write(folder, `uploads/${name}`, body);
    const { width, height, format } = await sharp(body).metadata();
    assert.equal(headers["content-type"], `image/${format}`);
    const key = searchParams.get("river_seed");
    assert.equal(key, name.replace(/\.\w+$/, ""));
    media[`_${key}`] = [`/blog/uploads/${name}`, width, height, searchParams.get("alt_text")];
    atOnce--;
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

test("WordPress: before there is a picture the place is kept, and its author's page asks for one", {
  skip,
}, async () => {
  const folder = await site("words");
  const reader = await render(folder, {});
  assert.match(
    reader,
    /aspect-ratio:1\.6;min-height:0;overflow:hidden"><p style="margin:0">A map of rivers<\/p><\/river-seed>/,
  );
  assert.match(reader, /<p style="margin:0">A valley whose river leaves to the south<\/p>/);
  for (const may of [[], ["upload_files"], ["upload_files", "edit_posts", "edit_post 8"], ["edit_post 7"]])
    assert.doesNotMatch(await render(folder, { may }), /data-poster|poster\.js/, `who may ${may}`);
  assert.match(await render(folder, { may: AUTHOR }), /data-poster="river-seed-[0-9a-f]{16}"/);
  for (const [link, aspect] of [
    ["seed=a&amp;aspect=2.5", "2.5"],
    ["https://rivers.example/?aspect=0.5&amp;seed=a", "0.5"],
    ["seed=a&amp;aspect=9", "4"],
    ["seed=a&amp;aspect=1;color:red", "1.6"],
  ])
    assert.match(
      await render(folder, { post: `[river-seed map="${link}"]` }),
      new RegExp(`style="display:block;aspect-ratio:${aspect};`),
      link,
    );
  await render(folder, {});
  await expectRivers(folder, { rivers: 2, pictures: 0 });
});

test("WordPress: a picture names its seed, unless the author says what it shows", { skip }, async () => {
  const folder = await site("links");
  const media = { [`_${nameOf("sea=0.5")}`]: ["/blog/a.webp", 1200, 750, "Rivers grown from “kauri”"] };
  const post = '[river-seed map="sea=0.5"][river-seed map="sea=0.5" alt="Our sea"]';
  const page = await render(folder, { post, media });
  assert.deepEqual(
    [...page.matchAll(/<img[^>]* alt="([^"]*)"/g)].map(([, alt]) => alt),
    ["Rivers grown from “kauri”", "Our sea"],
  );
});

test("WordPress: the element reads what people hand over, and words need no larger engine", { skip }, async () => {
  const folder = await site("given");
  for (const [map, tag] of [
    ["kauri", 'seed="kauri" edition="1"'],
    ["seed=rimu&amp;land=valley", 'recipe="seed=rimu&amp;land=valley" edition="1"'],
    [
      "https://rivers.example/?seed=rimu&amp;land=valley",
      'recipe="https://rivers.example/?seed=rimu&amp;land=valley" edition="1"',
    ],
    ["edition=1&amp;seed=b", 'recipe="edition=1&amp;seed=b"'],
  ]) {
    const page = await render(folder, { post: `[river-seed map="${map}"]` });
    assert.ok(page.includes(`<river-seed ${tag} style=`), page);
  }
});

test("WordPress: a post keeps only pictures that were sent for it, under a map's name", { skip }, async () => {
  const folder = await site("keep");
  const name = nameOf("kauri");
  assert.deepEqual(JSON.parse(await answer(folder, { upload: [100, 7, { river_seed: name }] })), [7, `_${name}`, 100]);
  for (const upload of [
    [100, 0, { river_seed: name }],
    [100, 7, { river_seed: "river-seed-../../etc" }],
    [100, 7, { river_seed: `${name}\n` }],
    [100, 7, { river_seed: null }],
  ])
    assert.equal(await answer(folder, { upload }), "", JSON.stringify(upload));
  const deleted = { [`_${name}`]: null };
  const post = '[river-seed map="kauri"]';
  assert.match(await render(folder, { post, may: AUTHOR, media: deleted }), /data-poster=/, "and another is asked for");
});

test("WordPress: no seed is a shortcode, in no attribute and no text", { skip }, async () => {
  const folder = await site("shortcodes");
  for (const word of ["[members]", "[members id=1]", "[[members]]", "[members/]", "a [members] b", "[river-seed]"]) {
    const media = { [`_${nameOf(word)}`]: ["/blog/a.webp", 1200, 750, `Rivers grown from “${word}”`] };
    const json = JSON.stringify({ map: word, alt: word });
    const post = `<!-- wp:river-seed/map ${json} /-->\n<!-- wp:river-seed/map ${JSON.stringify({ map: word })} /-->`;
    for (const page of [await render(folder, { post }), await render(folder, { post, media })]) {
      assert.doesNotMatch(page, /MEMBERS/, word);
      assert.equal(page.match(/<river-seed /g).length, 2, word);
      const seen = page.replaceAll("&#091;", "[").replaceAll("&#093;", "]");
      assert.ok(seen.includes(`${word.includes("=") ? "recipe" : "seed"}="${word}"`), seen);
    }
  }
  assert.match(await render(folder, { post: "[members]" }), /MEMBERS ONLY/, "shortcodes of an author's run");
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
  const attributes = ["data-media", "data-nonce", "data-post", "data-poster", "data-size"];
  // WordPress breaks lines where the author does.
  await expectHarmless(folder, unslashed, { own: "br", attributes });
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
