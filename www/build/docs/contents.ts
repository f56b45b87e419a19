/** The pages and their order. */

import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { type Article, articleOf } from "./article.ts";
import { READERS, sourceOf } from "./readers.ts";

/** The folder of the repository. */
export const REPOSITORY = fileURLToPath(new URL("../../../", import.meta.url));

/** Pages under a heading of the list of contents. */
export interface Group {
  readonly title: string;
  readonly articles: readonly Article[];
}

/** The systems that have an integration, by the names of their folders. */
const SYSTEMS = ["hugo", "jekyll", "eleventy", "astro", "mdx", "wordpress", "ghost", "observable", "quarto"];

const ORDER: readonly (readonly [title: string, sources: readonly string[]])[] = [
  ["Begin here", READERS.map(sourceOf)],
  ["On web pages", ["docs/element.md", "docs/iframe.md", "docs/hosting.md"]],
  [
    "Blogs and site generators",
    ["docs/blogs.md", "integrations/README.md", ...SYSTEMS.map((name) => `integrations/${name}/README.md`)],
  ],
  ["Maps and files", ["docs/parameters.md", "docs/files.md", "docs/engines.md", "docs/gis.md", "docs/hydrology.md"]],
  ["In programs", ["docs/command-line.md", "docs/batch.md", "python/README.md"]],
  ["How it works", ["docs/algorithms.md", "docs/glossary.md", "docs/benchmarks.md"]],
  ["Changing Riverseed", ["docs/adding.md", "docs/decisions.md", "docs/widget-checklist.md"]],
];
/** The names of pages whose title says something else, since it stands elsewhere, too: npm shows that of the element. */
const NAMES: Readonly<Record<string, string>> = {
  "docs/element.md": "The element",
  "integrations/README.md": "All integrations",
};

/** Returns all pages in groups. Throws an error that names the documents which are in no group, or in one but not there. */
export function contents(): Group[] {
  const faults = misplaced(documents());
  if (faults.length > 0) throw new Error(faults.join("\n"));
  return ORDER.map(([title, sources]) => ({ title, articles: sources.map(articleAt) }));
}

/** Returns what is wrong with the order for these documents: without a group, nobody would find one. */
export function misplaced(sources: readonly string[]): string[] {
  const placed = ORDER.flatMap(([, those]) => those);
  return [
    ...sources
      .filter((source) => !placed.includes(source))
      .map((source) => `${source}: the document is in no group of ${HERE}`),
    ...placed
      .filter((source) => !sources.includes(source))
      .map((source) => `${source}: ${HERE} names it, and it is not there`),
  ];
}

const HERE = "www/build/docs/contents.ts";

function articleAt(source: string): Article {
  const article = articleOf(source, readFileSync(join(REPOSITORY, source), "utf8"));
  return { ...article, title: NAMES[source] ?? article.title };
}

/** Returns the documents that are pages, sorted: those of docs, and the READMEs of the Python package and the integrations. */
export function documents(): string[] {
  const integrations = readdirSync(join(REPOSITORY, "integrations")).map((name) => `integrations/${name}/README.md`);
  const readmes = ["python/README.md", "integrations/README.md", ...integrations].filter(isThere);
  return [...documentsIn("docs"), ...readmes].sort();
}

function documentsIn(folder: string): string[] {
  return readdirSync(join(REPOSITORY, folder), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".md"))
    .map((name) => `${folder}/${name}`);
}

function isThere(source: string): boolean {
  return existsSync(join(REPOSITORY, source));
}

/** Returns the address of a document's page, relative to the folder of the pages. A README's page is called like its folder. */
export function addressOf(source: string): string {
  return source.replace(/^docs\//, "").replace(/(?:\/README)?\.md$/, ".html");
}

/** Returns the way from a page to the folder of the pages: empty, or `../` for each folder between. */
export function wayUp(address: string): string {
  return "../".repeat(address.split("/").length - 1);
}
