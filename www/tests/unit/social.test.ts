import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
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
  expect(html).toContain('<meta property="og:image" content="https://rivers.example/maps/river.png"');
  expect(html).not.toContain("./river.png");
});
