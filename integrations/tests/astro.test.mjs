import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE } from "./lib/hostile.mjs";
import { build, copied, LOOKS, placePictures, run, strangersIn, webpOf, write } from "./lib/workshop.mjs";

const QUIET = { ASTRO_TELEMETRY_DISABLED: "1" };
const astro = (source) => run(source, "astro", ["build"], QUIET);
const IMPORT = 'import RiverSeed from "../../../RiverSeed.astro";';

function site(name, changes) {
  const files = { astro: "", "river-seed.mjs": "river-seed.mjs", "example.css": "site/public/example.css" };
  const source = join(copied(`astro-${name}`, files, changes), "site");
  return { source, built: join(source, "dist") };
}

test("Astro: a blog under a path", async () => {
  const { source, built } = site("blog");
  await build(source, "astro", ["build"], QUIET);
  await expectRivers(built, { rivers: 2, picture: join(LOOKS, "astro.png") });
});

test("Astro: hostile words are text", async () => {
  const { source, built } = site("hostile");
  write(
    source,
    "src/pages/index.mdx",
    "---\nlayout: ../layouts/Post.astro\ntitle: Hostile\n---\n\n" +
      `${IMPORT}\n\nexport const words = ${JSON.stringify(HOSTILE)};\n\n{words.map((word) => <RiverSeed map={word} alt={word} />)}\n`,
  );
  await placePictures(join(source, "public/riverseed"), HOSTILE.map(webpOf));
  await build(source, "astro", ["build"], QUIET);
  await expectHarmless(built, HOSTILE);
  assert.deepEqual(strangersIn(built), []);
});

test("Astro: what stops the build is named, with its page", async () => {
  const { source } = site("bad");
  for (const [text, said] of [
    [
      '<RiverSeed map="seed=kauri&frog=1" />',
      /river-seed: no map of "seed=kauri&frog=1": there is no parameter 'frog'/,
    ],
    [
      '<RiverSeed map="kauri"><RiverSeed map="rimu" /></RiverSeed>',
      /river-seed: <RiverSeed> has no content; a map cannot stand in a map/,
    ],
  ]) {
    write(source, "src/pages/index.mdx", `${IMPORT}\n\n${text}\n`);
    const heard = await astro(source);
    assert.notEqual(heard.code, 0);
    assert.match(heard.said, said);
    assert.match(heard.said, /index\.mdx|index\.html|RiverSeed\.astro/);
  }
});

test("Astro: an element around an element, an older Astro and a forgotten integration are named", async () => {
  const nested = site("nested");
  await placePictures(join(nested.source, "public/riverseed"), [webpOf("kauri")]);
  write(nested.source, "src/pages/index.mdx", `${IMPORT}\n\n<river-seed><RiverSeed map="kauri" /></river-seed>\n`);
  assert.match((await astro(nested.source)).said, /river-seed: a river-seed stands inside another: .*index\.html/);
  const older = site("older", [["RiverSeed.astro", '"5.0"', '"99.0"']]);
  assert.match((await astro(older.source)).said, /river-seed: Astro 99\.0 or newer is needed; this is Astro v5/);
  const forgotten = site("forgotten", [["site/astro.config.mjs", ", riverSeed()", ""]]);
  assert.match(
    (await astro(forgotten.source)).said,
    /river-seed: integrations of astro\.config\.mjs lacks riverSeed\(\)/,
  );
});
