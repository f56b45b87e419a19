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

const ORDER: readonly (readonly [title: string, sources: readonly string[]])[] = [
  ["Begin here", READERS.map(sourceOf)],
  ["On web pages", ["docs/element.md", "docs/iframe.md", "docs/hosting.md"]],
  ["Maps and files", ["docs/parameters.md", "docs/files.md", "docs/engines.md", "docs/gis.md"]],
  ["In programs", ["docs/command-line.md", "docs/batch.md", "python/README.md"]],
  ["How it works", ["docs/algorithms.md", "docs/glossary.md", "docs/benchmarks.md"]],
  ["Changing Riverseed", ["docs/adding.md", "docs/decisions.md", "docs/widget-checklist.md"]],
];
/** The heading of pages that have no place in the order yet. */
const OTHERS = "More";
/** The names of pages whose title says something else, since it stands elsewhere, too: npm shows that of the element. */
const NAMES: Readonly<Record<string, string>> = { "docs/element.md": "The element" };

/** Returns all pages in groups. A document that has no place in the order comes last, so that none is left out. */
export function contents(): Group[] {
  const placed = ORDER.flatMap(([, sources]) => sources);
  const others = documentsIn("docs").filter((source) => !placed.includes(source));
  return [...ORDER, [OTHERS, others] as const]
    .map(([title, sources]) => ({
      title,
      articles: sources.filter(isThere).map(articleAt),
    }))
    .filter(({ articles }) => articles.length > 0);
}

function articleAt(source: string): Article {
  const article = articleOf(source, readFileSync(join(REPOSITORY, source), "utf8"));
  return { ...article, title: NAMES[source] ?? article.title };
}

/** Returns the documents in a folder and the folders in it, sorted. */
export function documentsIn(folder: string): string[] {
  return readdirSync(join(REPOSITORY, folder), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".md"))
    .map((name) => `${folder}/${name}`)
    .sort();
}

function isThere(source: string): boolean {
  return existsSync(join(REPOSITORY, source));
}

/** The addresses of pages that are not in docs, relative to the folder of the pages. */
const ELSEWHERE: Readonly<Record<string, string>> = { "python/README.md": "python.html" };

/** Returns the address of a document's page, relative to the folder of the pages. */
export function addressOf(source: string): string {
  return ELSEWHERE[source] ?? source.replace(/^docs\//, "").replace(/\.md$/, ".html");
}

/** Returns the way from a page to the folder of the pages: empty, or `../` for each folder between. */
export function wayUp(address: string): string {
  return "../".repeat(address.split("/").length - 1);
}
