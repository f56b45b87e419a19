import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { robots, sitemap } from "../../build/crawlers.ts";
import { contents } from "../../build/docs/contents.ts";
import { recipes } from "../../build/gallery/recipes.ts";
import { completed } from "../../build/social.ts";

const index = readFileSync(new URL("../../index.html", import.meta.url), "utf8");

test("the page's card has a picture, with its size and in words", () => {
  for (const tag of ["og:title", "og:description", "og:type", "og:image", "og:image:width", "og:image:alt"])
    expect(index).toContain(`<meta property="${tag}" content=`);
  expect(index).toContain('<meta name="twitter:card" content="summary_large_image"');
});

test("the picture is as large as is said", () => {
  const png = readFileSync(new URL("../../public/river.png", import.meta.url));
  expect(index).toContain(`<meta property="og:image:width" content="${png.readUInt32BE(16)}"`);
  expect(index).toContain(`<meta property="og:image:height" content="${png.readUInt32BE(20)}"`);
});

test("a site that knows its address has whole ones on its card", () => {
  const html = completed(index, "https://rivers.example/maps");
  expect(html).toContain('<meta property="og:url" content="https://rivers.example/maps/" />');
  expect(html).toContain('<link rel="canonical" href="https://rivers.example/maps/" />');
  expect(html).toContain('<meta property="og:image" content="https://rivers.example/maps/river.png"');
  expect(html).not.toContain("./river.png");
});

test("who looks for pages may, and is told of all where the site knows its address", () => {
  expect(robots(undefined)).toBe("User-agent: *\nAllow: /\n");
  expect(robots("https://rivers.example/maps")).toContain("\nSitemap: https://rivers.example/maps/sitemap.xml\n");
  const pages = [...sitemap("https://rivers.example/a&b/").matchAll(/<loc>([^<]*)<\/loc>/g)].map(([, page]) => page);
  const documents = contents().flatMap(({ articles }) => articles);
  expect(pages).toHaveLength(recipes.length + documents.length + 3);
  expect(pages.slice(0, 2)).toEqual(["https://rivers.example/a&amp;b/", "https://rivers.example/a&amp;b/gallery/"]);
  expect(pages).toContain(`https://rivers.example/a&amp;b/gallery/${recipes[0]?.slug}.html`);
  expect(pages).toContain("https://rivers.example/a&amp;b/docs/for/teachers.html");
});
