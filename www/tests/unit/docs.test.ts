import { posix } from "node:path";
import { expect, test } from "vitest";
import { articleOf } from "../../build/docs/article.ts";
import { addressOf, contents, documents, misplaced } from "../../build/docs/contents.ts";
import { pictures } from "../../build/docs/pictures.ts";
import { writtenFor } from "../../build/docs/plugin.ts";
import { bodyOf } from "../../build/docs/rendering.ts";
import { filesOf } from "../../build/gallery/pages.ts";
import { recipes } from "../../build/gallery/recipes.ts";

const place = {
  site: undefined,
  sheet: "assets/docs.css",
  script: "assets/docs.js",
  siteScript: "assets/docs-site.js",
  hasPolicy: true,
};
const files = writtenFor(place);
const pages = pagesOf(files);

function pagesOf(written: ReturnType<typeof writtenFor>): [name: string, html: string][] {
  return [...written].filter(([name]) => name.endsWith(".html")).map(([name, html]) => [name, `${html}`]);
}

function bodyOfText(text: string, site?: string): string {
  const article = articleOf("docs/some.md", text);
  return bodyOf(article, new Map([[article.source, article]]), site).html;
}

function attributes(html: string, name: string): string[] {
  return [...html.matchAll(new RegExp(` ${name}="([^"]*)"`, "g"))].map(([, value = ""]) => value);
}

test("every document of docs has a page, and so have the READMEs of the Python package and of each integration", () => {
  for (const source of documents()) expect([...files.keys()]).toContain(addressOf(source));
  for (const page of ["index.html", "files.html", "python.html", "integrations.html", "integrations/hugo.html"])
    expect(files.has(page), page).toBe(true);
});

test("a document that is in no group is told by name, and so is one that a group has and the repository has not", () => {
  expect(misplaced(documents())).toEqual([]);
  expect(misplaced([...documents().filter((source) => source !== "docs/gis.md"), "docs/new.md"])).toEqual([
    "docs/new.md: the document is in no group of www/build/docs/contents.ts",
    "docs/gis.md: www/build/docs/contents.ts names it, and it is not there",
  ]);
});

test("bloggers get from their first page to the set-up of each system", () => {
  const leadsTo = (page: string) => attributes(mainOf(`${files.get(page)}`), "href");
  expect(leadsTo("for/bloggers.html")).toContain("../blogs.html");
  const systems = documents().filter((source) => /^integrations\/.+\/README\.md$/.test(source));
  expect(systems.length).toBeGreaterThan(5);
  for (const source of systems) {
    expect(leadsTo("blogs.html"), source).toContain(addressOf(source));
    expect(leadsTo("integrations.html"), source).toContain(addressOf(source));
  }
});

/** Returns a page's text without the list of contents and the ways to the next page. */
function mainOf(html: string): string {
  return html.slice(html.indexOf("<main"), html.indexOf('<nav class="around"'));
}

test("the list of contents has every page once", () => {
  const listed = contents().flatMap(({ articles }) => articles.map(({ source }) => source));
  expect(new Set(listed).size).toBe(listed.length);
  expect(listed).toHaveLength(pages.length - 1);
  const html = `${files.get("index.html")}`;
  for (const source of listed)
    expect(html.slice(html.indexOf('id="contents"'))).toContain(`href="${addressOf(source)}"`);
});

const ELSEWHERE = new Set([
  "",
  "assets/docs.css",
  "assets/docs.js",
  "assets/docs-site.js",
  "gallery/",
  "examples/blog.html",
  "real-or-grown.html",
  ...[...pictures().values()].flatMap(({ card, page }) => [card.address, page.address]),
  ...recipes.flatMap(({ slug }) => Object.values(filesOf(slug)).map((file) => `gallery/${file}`)),
]);

test("whatever a page leads to is there, down to the heading", () => {
  for (const [name, html] of pages)
    for (const target of [...attributes(html, "href"), ...attributes(html, "src")]) {
      if (/^(https?|data):/.test(target)) continue;
      const [path = "", anchor] = target.replace(/\?[^#]*/, "").split("#");
      const whole = path === "" ? `docs/${name}` : posix.join("docs", posix.dirname(name), path);
      const found = whole.endsWith("docs/") ? `${whole}index.html` : whole;
      if (!found.startsWith("docs/") || found.endsWith(".webp"))
        expect(ELSEWHERE, `${name}: ${target}`).toContain(found === "./" ? "" : found);
      else {
        expect([...files.keys()], `${name}: ${target}`).toContain(found.slice("docs/".length));
        if (anchor)
          expect(`${files.get(found.slice("docs/".length))}`, `${name}: ${target}`).toContain(` id="${anchor}"`);
      }
    }
});

test("a broken link, an anchor that no heading has, and a missing picture are told with file and line, all at once", () => {
  const text =
    "# Title\n\nSome [words](nowhere.md).\n\n- fine\n- [here](#title), [there](#none)\n\n![](figures/none.svg)\n";
  expect(() => bodyOfText(text)).toThrow(
    [
      "docs/some.md:3: there is no nowhere.md",
      "docs/some.md:6: docs/some.md has no heading #none",
      "docs/some.md:8: figures/none.svg cannot be read, or has no size",
    ].join("\n"),
  );
});

test.each([
  "javascript:alert(1)",
  "data:text/html,x",
  "//example.net/",
  "/etc/passwd",
  "../../../etc/passwd",
  "https://example.org/riverseed/none.html",
])("no page leads to %s", (href) => {
  expect(() => bodyOfText(`# Title\n\n[words](${href})\n`)).toThrow("docs/some.md:3: ");
});

test("a link to a folder leads to its README's page", () => {
  const all = new Map(contents().flatMap(({ articles }) => articles.map((one) => [one.source, one])));
  const htmlOf = (source: string, text: string) =>
    bodyOf(articleOf(source, `# Title\n\n${text}\n`), all, undefined).html;
  expect(htmlOf("integrations/mdx/README.md", "[it](../ghost)")).toContain(
    '<a href="../integrations/ghost.html">it</a>',
  );
  expect(htmlOf("docs/for/bloggers.md", "[it](../../integrations/)")).toContain(
    '<a href="../integrations.html">it</a>',
  );
  expect(() => htmlOf("docs/some.md", "[it](../integrations/ghost#none)")).toThrow(
    "docs/some.md:3: integrations/ghost/README.md has no heading #none",
  );
});

test("a link to what only the repository has leaves its words", () => {
  expect(bodyOfText("# Title\n\nSee [the table](../src/recipe/table.rs).\n")).toContain("See the table.");
});

test("headings have the names that code hosts give them", () => {
  const text = "# A title\n\n## What the *Share* dialog gives\n\n## `www`: C++ & more\n\n## Twice\n\n## Twice\n";
  const { headings } = articleOf("docs/some.md", text);
  expect(headings.map(({ id }) => id)).toEqual([
    "a-title",
    "what-the-share-dialog-gives",
    "www-c--more",
    "twice",
    "twice-1",
  ]);
});

test("a row that explains a word of code has its name, once on a page", () => {
  const text =
    "# Title\n\n## Land\n\n| key | |\n| --- | --- |\n| `land` | a |\n| `sea` | b |\n| `sea` | c |\n| `a b` | d |\n| `e` f | |\n";
  expect([...bodyOfText(text).matchAll(/<tr id="([^"]*)"/g)].map(([, id]) => id)).toEqual(["sea"]);
});

test("a document without a title, or with two, has no page", () => {
  for (const text of ["words\n", "# One\n\n# Two\n"])
    expect(() => articleOf("docs/some.md", text)).toThrow("docs/some.md: ");
});

test("comments are left out, other HTML is refused, and code stays text", () => {
  expect(bodyOfText("# Title\n\n<!-- table: none -->\n\nwords\n")).not.toContain("table");
  expect(() => bodyOfText("# Title\n\n<!-- a --><b>words</b><!-- b -->\n")).toThrow("docs/some.md:3: ");
  expect(() => bodyOfText("# Title\n\n<b>words</b>\n")).toThrow("docs/some.md:3: ");
  expect(() => bodyOfText("# Title\n\nsome <i>words</i>\n")).toThrow("docs/some.md:3: ");
  const html = bodyOfText(
    "# Title `<b>`\n\n```html\n<script>alert(1)</script>\n```\n\n`<i>`\n\n| `<u>` |\n| --- |\n| a |\n",
  );
  expect(html).not.toMatch(/<(script|b|i|u)>/);
});

test("no page has a script or a style of its own, which its policy would not let run", () => {
  for (const [name, html] of pages) {
    expect(html.match(/<script(?! type="module" (?:blocking="render" )?src=")/g), name).toBeNull();
    expect(html.match(/<style|<[^>]* (?:style|on\w+)=/g), name).toBeNull();
    expect(html, name).toContain('http-equiv="Content-Security-Policy"');
  }
});

test("every page says in a title of its own what it is about, and has a description of a length that is shown", () => {
  const said = (pattern: RegExp) => pages.map(([, html]) => pattern.exec(html)?.[1] ?? "");
  const titles = said(/<title>([^<]+)<\/title>/);
  expect(new Set(titles).size).toBe(pages.length);
  for (const description of said(/name="description" content="([^"]+)"/)) {
    expect(description.length).toBeGreaterThan(15);
    expect(description.length).toBeLessThan(260);
  }
});

test("what readers paste has the site's address if that is known, and is marked for the browser to fill in if not", () => {
  const text =
    "# Title\n\n```text\nhttps://example.org/riverseed/?seed=kea&curl=1\n```\n\n`https://example.org/riverseed/` stands for a site.\n";
  const unknown = bodyOfText(text);
  expect(unknown).toContain("<code><span data-site>https://example.org/riverseed/</span>?seed=kea&amp;curl=1</code>");
  expect(unknown).toContain("<noscript><p>");
  const known = bodyOfText(text, 'https://rivers.example/"maps');
  expect(known).toContain("<code>https://rivers.example/&quot;maps/?seed=kea&amp;curl=1</code>");
  expect(known).not.toContain("stands for");
  for (const html of [unknown, known]) expect(html).toContain('<a href="../?seed=kea&amp;curl=1">Open it</a>');
});

test("a site that knows its address has it wherever the stand-in was, and needs no script for that", () => {
  for (const [name, html] of pagesOf(writtenFor({ ...place, site: "https://rivers.example/maps" }))) {
    expect(html, name).not.toMatch(/docs-site|data-site/);
    // One page tells how the stand-in is used.
    if (name !== "adding.html") expect(html, name).not.toContain("example.org");
    expect(html, name).toMatch(/rel="canonical" href="https:\/\/rivers\.example\/maps\/docs\//);
  }
});
