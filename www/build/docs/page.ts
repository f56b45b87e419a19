/** Writes the page of a document. */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import type { Article, Heading } from "./article.ts";
import { addressOf, type Group, wayUp } from "./contents.ts";
import { documentOf, type Place } from "./frame.ts";
import type { Picture, Pictures } from "./pictures.ts";
import { READERS, sourceOf } from "./readers.ts";
import { type Body, bodyOf } from "./rendering.ts";

/** The least number of sections of a page that lists them. */
const FEWEST = 3;

/** The share of the size of a gallery's picture at which a page shows it, so that one of any shape leaves room for the text. */
const SHOWN = 0.64;

/** A page of the documentation. */
export interface Page {
  readonly html: string;
  readonly figures: Body["figures"];
}

export function pageOf(article: Article, groups: readonly Group[], pictures: Pictures, place: Place): Page {
  const articles = groups.flatMap((group) => group.articles);
  const all = new Map(articles.map((one) => [one.source, one]));
  const { html, figures } = bodyOf(article, all, place.site);
  const at = articles.findIndex(({ source }) => source === article.source);
  const sections = article.headings.filter(({ depth }) => depth === 2);
  const lists = sections.length >= FEWEST ? sections : [];
  const reader = READERS.find((one) => sourceOf(one) === article.source);
  const body = `<main${reader ? ' class="reader"' : ""}>
      ${withSections(withPicture(html, pictures.get(reader?.name ?? ""), article), lists)}
      ${aroundOf(article, articles[at - 1], articles[at + 1])}
    </main>
    ${lists.length > 0 ? `<nav class="sections" aria-labelledby="sections"><h2 id="sections">On this page</h2>${listOf(lists)}</nav>` : ""}`;
  return {
    html: documentOf(place, {
      title: `${article.title} · Riverseed`,
      description: article.lead,
      address: addressOf(article.source),
      kind: "article",
      body,
      groups,
      current: article,
    }),
    figures,
  };
}

/** Adds a folded list of the sections for windows that have no room beside the text. */
function withSections(html: string, sections: readonly Heading[]): string {
  if (sections.length === 0) return html;
  const fold = `<details class="fold"><summary>On this page</summary>${listOf(sections)}</details>`;
  return html.replace(/(?=<h2 )/, () => `${fold}\n`);
}

function listOf(sections: readonly Heading[]): string {
  return `<ul>${sections.map(({ id, text }) => `<li><a href="#${escaped(id)}">${escaped(text)}</a></li>`).join("")}</ul>`;
}

/** Shows the map that a reader's first code makes below that code. */
function withPicture(html: string, shown: Picture | undefined, { source }: Article): string {
  if (!shown) return html;
  const root = `${wayUp(addressOf(source))}../`;
  const { link, sentence, page } = shown;
  const [width, height] = [page.width, page.height].map((side) => Math.round(side * SHOWN));
  const picture = `<a class="makes" href="${escaped(`${root}?${link}`)}"><img src="${root}${page.address}" width="${width}" height="${height}" alt="The map that this makes: ${escaped(sentence)}" /></a>`;
  return html.replace("</figure>", () => `</figure>\n${picture}`);
}

function aroundOf({ source }: Article, before: Article | undefined, after: Article | undefined): string {
  const way = wayUp(addressOf(source));
  const link = (to: Article | undefined, rel: "prev" | "next", text: (title: string) => string) =>
    to ? `<a href="${way}${addressOf(to.source)}" rel="${rel}">${text(escaped(to.title))}</a>` : "<span></span>";
  return `<nav class="around" aria-label="Before and after">${link(before, "prev", (title) => `← ${title}`)}${link(after, "next", (title) => `${title} →`)}</nav>`;
}
