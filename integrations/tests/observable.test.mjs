import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { expectHarmless, expectRivers } from "./lib/browser.mjs";
import { HOSTILE } from "./lib/hostile.mjs";
import { build, copied, filesOf, LOOKS, placePictures, webpOf, write } from "./lib/workshop.mjs";

const BUILD = ["build", "rivers.html", "--out", "dist", "--base", "./"];

const site = (name) =>
  copied(`observable-${name}`, { observable: "", "ghost/card.mjs": "card.mjs", "river-seed.mjs": "river-seed.mjs" });
/** A cell in a notebook's file ends at the first end of a script. */
const cell = (html) => html.replaceAll("</script>", "<\\/script>");

test("Observable: the notebook, whose card is what card.mjs prints", async () => {
  const folder = site("notebook");
  const notebook = readFileSync(join(folder, "rivers.html"), "utf8");
  const card = await import(join(folder, "river-seed.mjs")).then(async ({ embed, html, copyElement }) => {
    await copyElement(join(folder, "riverseed"));
    return html(await embed("kauri", { folder: join(folder, "riverseed"), base: "./riverseed/" }));
  });
  assert.ok(notebook.includes(`\n    ${cell(card)}\n`), `the notebook's card is not ${cell(card)}`);
  await build(folder, "notebooks", BUILD);
  await expectRivers(join(folder, "dist"), {
    rivers: 2,
    pictures: 1,
    hasFonts: false,
    page: "rivers.html",
    picture: join(LOOKS, "observable.png"),
  });
});

test("Observable: hostile words are text", async () => {
  const folder = site("hostile");
  await placePictures(join(folder, "riverseed"), HOSTILE.map(webpOf));
  const { embed, html, copyElement } = await import(join(folder, "river-seed.mjs"));
  await copyElement(join(folder, "riverseed"));
  const cards = [];
  for (const word of HOSTILE)
    cards.push(html(await embed(word, { folder: join(folder, "riverseed"), base: "./riverseed/" })));
  const cells = cards.map((card, i) => `<script id="${i + 1}" type="text/html">${cell(card)}</script>`);
  write(
    folder,
    "rivers.html",
    `<!doctype html>\n<notebook>\n<title>Hostile</title>\n${cells.join("\n")}\n</notebook>\n`,
  );
  await build(folder, "notebooks", BUILD);
  await expectHarmless(join(folder, "dist"), HOSTILE, {
    page: "rivers.html",
    pictures: /^(data:image\/webp;base64,[\w+/=]+|\.\/assets\/river-seed-[0-9a-f]{16}-[\w-]+\.webp)$/,
    own: "div.observablehq",
  });
  assert.deepEqual(
    filesOf(join(folder, "dist")).filter(
      (file) => !/^(rivers\.html|assets\/[\w.-]+\.(js|css|wasm|webp|woff2))$/.test(file),
    ),
    [],
  );
});
