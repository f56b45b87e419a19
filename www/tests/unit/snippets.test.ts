import { expect, test } from "vitest";
import {
  elementSnippet,
  embedAddress,
  iframeSnippet,
  markdownSnippet,
  type Shared,
  titleOf,
  withoutDefaultStyle,
} from "../../src/apps/page/share/snippets.ts";

const shared = (link: string): Shared => ({
  link,
  seed: new URLSearchParams(link).get("seed") ?? "",
  aspect: "1.5",
  page: "https://rivers.example/maps/?seed=shown#there",
});

test("an element has a river's values as attributes, its room, and a picture that leads to the page", () => {
  expect(elementSnippet(shared("seed=kauri&edition=1&curl=0.6&meander-rounds=9"), "riverseed-kauri.png")).toBe(
    `<script type="module" src="https://rivers.example/maps/widget/river-seed.js"></script>
<river-seed seed="kauri" edition="1" curl="0.6" meander-rounds="9" maker="https://rivers.example/maps/" style="display:block;aspect-ratio:1.5;min-height:0;overflow:hidden">
  <a href="https://rivers.example/maps/?seed=kauri&amp;edition=1&amp;curl=0.6&amp;meander-rounds=9"><img src="riverseed-kauri.png"
    alt="Rivers grown from “kauri”" loading="lazy" style="display:block;width:100%"></a>
</river-seed>`,
  );
});

test("keys that HTML has for itself carry a prefix", () => {
  expect(elementSnippet(shared("seed=a&width=20&style=atlas"), "p.png")).toContain(
    `<river-seed seed="a" river-width="20" river-style="atlas" maker="https://rivers.example/maps/" style="display:block;`,
  );
});

test("an element carries its letters, and nothing else does", () => {
  const carrying = { ...shared("seed=a&names=t:x"), letters: "B-_9" };
  expect(elementSnippet(carrying, "p.png")).toContain(
    '<river-seed seed="a" names="t:x" letters="B-_9" maker="https://rivers.example/maps/" style="display:block;',
  );
  expect(iframeSnippet(carrying) + markdownSnippet(carrying, "p.png")).not.toContain("B-_9");
});

test("an iframe is named, lazy, fenced in, and has the river's shape", () => {
  expect(iframeSnippet({ ...shared("seed=kauri&aspect=2"), aspect: "2" })).toBe(
    `<iframe src="https://rivers.example/maps/embed.html?seed=kauri&amp;aspect=2"
  title="Rivers grown from “kauri”" loading="lazy" sandbox="allow-scripts allow-same-origin"
  width="720" height="360" style="width:100%;height:auto;aspect-ratio:2;border:0"></iframe>`,
  );
});

test("a widget follows its page unless a style of one's own was chosen, and the page that it leads to has the whole link", () => {
  const link = "seed=a&style=atlas&curl=0.6";
  const following = { ...shared(link), widgetLink: withoutDefaultStyle(link, "atlas") };
  expect(elementSnippet(following, "p.png")).toContain(
    '<river-seed seed="a" curl="0.6" maker="https://rivers.example/maps/" style="display:block;',
  );
  expect(elementSnippet(following, "p.png")).toContain("?seed=a&amp;style=atlas&amp;curl=0.6");
  expect(iframeSnippet(following)).toContain('embed.html?seed=a&amp;curl=0.6"');
  expect(withoutDefaultStyle(link, "night")).toBe(link);
  expect(withoutDefaultStyle("seed=style%3Datlas&names=t.style=atlas", "atlas")).toBe(
    "seed=style%3Datlas&names=t.style=atlas",
  );
});

test("the address for notebooks is the one of the iframe", () => {
  expect(embedAddress(shared("seed=kauri&aspect=2"))).toBe(
    "https://rivers.example/maps/embed.html?seed=kauri&aspect=2",
  );
});

test("Markdown is a picture that leads to the page", () => {
  expect(markdownSnippet(shared("seed=kauri&curl=0.6"), "riverseed-kauri.png")).toBe(
    "[![Rivers grown from “kauri”](riverseed-kauri.png)](https://rivers.example/maps/?seed=kauri&curl=0.6)",
  );
});

test("rivers without a word have a title too", () => {
  expect(titleOf("")).toBe("Rivers");
});

for (const seed of ['"><script>alert(1)</script>', "' onload='alert(1)", "&quot;&amp;", "a-->b", "</river-seed><b>"]) {
  test(`no sign of HTML leaves the seed ${seed} as it is`, () => {
    const link = `seed=${encodeURIComponent(seed)}`;
    for (const snippet of [elementSnippet(shared(link), `${seed}.png`), iframeSnippet(shared(link))]) {
      expect(snippet).not.toContain(seed);
      expect(snippet.split("<script")).toHaveLength(snippet.startsWith("<script") ? 2 : 1);
    }
  });
}

test("no sign of Markdown ends the picture's text or the link", () => {
  const snippet = markdownSnippet(shared("seed=a%5D(b)*c_%60%3Ci%3E%5C"), "p.png");
  expect(snippet).toBe(
    "[![Rivers grown from “a\\]\\(b\\)\\*c\\_\\`\\<i\\>\\\\”](p.png)](https://rivers.example/maps/?seed=a%5D%28b%29*c_%60%3Ci%3E%5C)",
  );
});
