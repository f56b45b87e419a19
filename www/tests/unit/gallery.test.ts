import { expect, test } from "vitest";
import { oembedOf, overviewPage, pageOf } from "../../build/gallery/pages.ts";
import { type Entry, entries, recipes } from "../../build/gallery/recipes.ts";
import { cardShot } from "../../build/gallery/shots.ts";
import { table } from "../table.ts";
import { engine } from "../whole.ts";

const all = entries();
const place = { site: undefined, sheet: "../gallery.css", hasPolicy: true };

test("there are at least 24 maps, each with an address, a name and a sentence of its own", () => {
  expect(recipes.length).toBeGreaterThanOrEqual(24);
  for (const what of ["slug", "title", "sentence", "link"] as const) {
    const said = recipes.map((recipe) => recipe[what]);
    expect(new Set(said).size, what).toBe(said.length);
  }
  for (const { slug, title, sentence } of recipes) {
    expect(slug).toMatch(/^[a-z][a-z0-9-]*$/);
    expect(title).toMatch(/^\p{Lu}[\p{L} ]*$/u);
    expect(sentence).toMatch(/^\p{Lu}.{20,130}\.$/u);
  }
});

test("a link is read without a notice and is canonical, so that it stays the same picture, on a dark page too", () => {
  for (const { link } of recipes)
    for (const dark of [false, true]) {
      const reading = engine.readLink(link, { dark });
      expect(reading.notices, link).toEqual([]);
      expect(reading.namesStyle, link).toBe(true);
      expect(engine.readLink(link, { dark: true }).sharedLink).toBe(link);
      expect(new Map(reading.values)).toEqual(new Map(engine.readLink(link).values));
    }
});

test("all styles are to be seen", () => {
  const styles = table.parameters.find(({ key }) => key === "style")?.choices ?? [];
  const seen = new Set(recipes.map(({ link }) => new URLSearchParams(link).get("style")));
  expect([...seen].sort()).toEqual(styles.map(({ value }) => value).sort());
});

test("pictures in the overview keep their room and are described; those beyond the first screen wait", () => {
  const html = overviewPage(all, place);
  const pictures = html.match(/<img [^>]*>/g) ?? [];
  expect(pictures).toHaveLength(all.length);
  for (const [i, picture] of pictures.entries()) {
    expect(picture).toMatch(/ width="\d+" height="\d+" alt="[^"]{20,}"/);
    expect(picture.includes('loading="lazy"')).toBe(i >= 6);
  }
});

test("the element is offered where it grows the whole map, and a picture elsewhere", () => {
  const code = (entry: Entry) => pageOf(entry, { before: entry, after: entry }, place);
  const [element, picture] = [true, false].map((suits) => all.find(({ suitsElement }) => suitsElement === suits));
  expect(element && code(element)).toContain("&lt;river-seed ");
  expect(picture && code(picture)).not.toContain("&lt;river-seed ");
  expect(picture && code(picture)).toContain("&lt;img ");
});

test("a site that knows its address says it on every card, and in what others paste", () => {
  const [entry] = all;
  if (!entry) throw new Error("the gallery is empty");
  const html = pageOf(entry, { before: entry, after: entry }, { ...place, site: "https://rivers.example/maps" });
  expect(html).toContain(`property="og:image" content="https://rivers.example/maps/gallery/${entry.slug}-card.jpg"`);
  expect(html).toContain(`rel="canonical" href="https://rivers.example/maps/gallery/${entry.slug}.html"`);
  expect(html).toContain("https://rivers.example/maps/widget/river-seed.js");
  expect(html).not.toContain("example.org");
});

test("a site that knows its address names an oEmbed response on each map's page, whose frame shows that map", () => {
  const [entry] = all;
  if (!entry) throw new Error("the gallery is empty");
  const around = { before: entry, after: entry };
  const html = pageOf(entry, around, { ...place, site: "https://rivers.example/maps/" });
  const address = `https://rivers.example/maps/gallery/${entry.slug}-oembed.json`;
  expect(html).toContain(`<link rel="alternate" type="application/json+oembed" href="${address}"`);
  expect(pageOf(entry, around, place)).not.toContain("oembed");
  const response = JSON.parse(oembedOf({ ...entry, title: '"><b>' }, "https://rivers.example/maps"));
  expect(response).toMatchObject({ version: "1.0", type: "rich", title: '"><b>', width: 720 });
  expect(response.height).toBe(Math.round(720 / Number(entry.aspect)));
  const [, frame = "", title] = /^<iframe src="([^"]*)" title="([^"]*)"/.exec(response.html) ?? [];
  expect(title).toBe("&quot;&gt;&lt;b&gt;");
  expect(frame.replaceAll("&amp;", "&")).toBe(`https://rivers.example/maps/embed.html?${entry.link}`);
});

test("what stands in a page is text, whatever a recipe says", () => {
  const [entry] = all;
  if (!entry) throw new Error("the gallery is empty");
  const hostile = { ...entry, title: '<b>"', sentence: "<i>", link: "seed=%3Cscript%3E", seed: "<script>" };
  const html = pageOf(hostile, { before: hostile, after: hostile }, place);
  expect(html).not.toMatch(/<b>|<i>|<script/);
});

test("a card shows an island whole, and no end of other lands", () => {
  const [left = 0, , across = 0] = cardShot(1, "Name", "island").framing ?? [];
  expect(left).toBeLessThan(0);
  expect(left + across).toBeGreaterThan(1);
  for (const aspect of [0.5, 1, 1.6, 3]) {
    const [west = -1, north = -1, wide = 2] = cardShot(aspect, "Name", "continent").framing ?? [];
    expect(west).toBeGreaterThanOrEqual(0);
    expect(north).toBeGreaterThanOrEqual(0);
    expect(west + wide).toBeLessThanOrEqual(1 + 1e-9);
    expect(north + (wide * 630) / 1200).toBeLessThanOrEqual(1 / aspect + 1e-9);
  }
});
