/** What README and the guides give to paste into a page, pasted. */

import { readFileSync } from "node:fs";
import { complaints } from "../riverpage.ts";
import { expect, test } from "./hosts.ts";
import { heard, listen } from "./post.ts";

/** Returns the blocks of a language in a document. */
function blocks(document: string, language: string): string[] {
  const text = readFileSync(new URL(`../../../../${document}`, import.meta.url), "utf8");
  return [...text.matchAll(/^```(\w+)\n([\s\S]*?)^```/gm)].flatMap(([, lang, code = ""]) =>
    lang === language ? [code] : [],
  );
}

const page = (body: string): string =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A post</title><link rel="icon" href="data:,"></head><body>${body}</body></html>`;

for (const document of ["README.md", "docs/for/bloggers.md"]) {
  test(`${document}: the snippet draws its map`, async ({ page: tab, blog }) => {
    const [snippet = "", ...more] = blocks(document, "html");
    expect(more).toEqual([]);
    const said = complaints(tab);
    const events = await listen(tab);
    // The files are where the document says that they are put.
    const moved = snippet.replace(/src="[^"]*river-seed\.js"/, 'src="/widget/river-seed.js"');
    expect(moved).not.toBe(snippet);
    blog.answer("/", { body: page(moved) });
    blog.answer("/kauri.png", { headers: { "content-type": "image/png" }, body: readFileSync("public/river.png") });
    await tab.goto(blog.origin);
    await heard(events, "complete");
    await expect(tab.locator("river-seed canvas:not(.waits)")).toBeVisible();
    expect(said).toEqual([]);
  });
}

test("docs/for/javascript.md: the programs for pages put an element in and hear its numbers", async ({
  page: tab,
  blog,
}) => {
  const programs = blocks("docs/for/javascript.md", "js").filter(
    (program) => program.includes("<river-seed") || program.includes('"river-seed"'),
  );
  expect(programs).toHaveLength(2);
  const logged: unknown[] = [];
  tab.on("console", async (message) => logged.push(await message.args()[0]?.jsonValue()));
  const map = '<script type="importmap">{ "imports": { "riverseed/define": "/widget/river-seed.js" } }</script>';
  blog.answer("/", { body: page(`${map}<script type="module">${programs.join("\n")}</script>`) });
  await tab.goto(blog.origin);
  await expect.poll(() => logged).toEqual([expect.objectContaining({ sources: expect.any(Number) })]);
  await expect(tab.locator("river-seed")).toHaveJSProperty("seed", "rimu");
});
