/** The frame of every page: head, header with the search, list of contents. */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import { icon } from "../gallery/templates.ts";
import { policyFor } from "../policy.ts";
import { baseOf } from "../social.ts";
import type { Article } from "./article.ts";
import { addressOf, type Group, wayUp } from "./contents.ts";

/** The folder of the pages in the site. */
export const FOLDER = "docs";
/** The file with the index of the search, in that folder. */
export const INDEX = "search.json";

/** The site for which the pages are made. */
export interface Place {
  /** The site's address, if it is known. */
  readonly site: string | undefined;
  /** The addresses of the style sheet and the script, relative to the site. */
  readonly sheet: string;
  readonly script: string;
  /** The address of the script that fills in the site's address. */
  readonly siteScript: string;
  /** True if pages have a Content-Security-Policy, which those of the dev server do not. */
  readonly hasPolicy: boolean;
}

interface Content {
  readonly title: string;
  readonly description: string;
  /** The page's address, relative to the folder of the pages. */
  readonly address: string;
  /** The page's own class. */
  readonly kind: "first" | "article";
  readonly body: string;
  readonly groups: readonly Group[];
  /** The page that the list of contents marks, if it is one of them. */
  readonly current?: Article;
}

/** The most characters of a description: more is cut off by those who show it. */
const LONGEST = 200;

export function documentOf(place: Place, content: Content): string {
  const { address, kind, body, groups, current } = content;
  const way = wayUp(address);
  return `<!doctype html>
<html lang="en">
  <head>
    ${headOf(place, content, `${way}../`).join("\n    ")}
  </head>
  <body class="${kind}" data-root="${way}../">
    <header class="top">
      <p class="places"><a href="${way}../">Riverseed</a> <span aria-hidden="true">/</span> <a href="${way || "./"}"${kind === "first" ? ' aria-current="page"' : ""}>Documentation</a></p>
      ${searchOf(way)}
      <a class="to-contents" href="#contents">Contents</a>
    </header>
    ${body}
    ${contentsOf(groups, way, current)}
  </body>
</html>
`;
}

/** Returns the elements of the head. `root` leads from the page to the site. */
function headOf(place: Place, { title, description, address }: Content, root: string): string[] {
  const { site, sheet, script, siteScript, hasPolicy } = place;
  const meta = (name: string, text: string) =>
    `<meta ${name.startsWith("og:") ? "property" : "name"}="${name}" content="${escaped(text)}" />`;
  const module = (file: string, more = "") => `<script type="module"${more} src="${escaped(root + file)}"></script>`;
  const said = shortened(description || title);
  return [
    ...(hasPolicy ? [`<meta http-equiv="Content-Security-Policy" content="${policyFor("")}" />`] : []),
    '<meta charset="utf-8" />',
    '<meta name="viewport" content="width=device-width, initial-scale=1" />',
    `<title>${escaped(title)}</title>`,
    meta("description", said),
    meta("color-scheme", "light dark"),
    meta("og:title", title),
    meta("og:description", said),
    meta("og:type", "article"),
    ...(site === undefined ? [] : [`<link rel="canonical" href="${escaped(wholeAddress(address, site))}" />`]),
    `<link rel="icon" href="${icon()}" />`,
    `<link rel="stylesheet" href="${escaped(root + sheet)}" />`,
    ...(site === undefined ? [module(siteScript, ' blocking="render"')] : []),
    module(script),
  ];
}

function wholeAddress(address: string, site: string): string {
  return new URL(`${FOLDER}/${address}`, baseOf(site)).href;
}

/** Returns a description that is no longer than is shown, whole words only. */
function shortened(text: string): string {
  return text.length <= LONGEST ? text : `${text.slice(0, text.lastIndexOf(" ", LONGEST - 2))} …`;
}

/** Writes the search. The style sheet hides it where there are no scripts. */
function searchOf(way: string): string {
  return `<search id="search" data-way="${way}" data-index="${way}${INDEX}">
        <input type="search" aria-label="Search the documentation" placeholder="Search" aria-keyshortcuts="/" autocomplete="off" autocapitalize="none" spellcheck="false" enterkeyhint="go" />
        <kbd aria-hidden="true">/</kbd>
        <div class="found"><ul aria-label="Results" hidden></ul><p role="status"></p></div>
      </search>`;
}

function contentsOf(groups: readonly Group[], way: string, current: Article | undefined): string {
  const item = (article: Article) => {
    const mark = article.source === current?.source ? ' aria-current="page"' : "";
    return `<li><a href="${way}${addressOf(article.source)}"${mark}>${escaped(article.title)}</a></li>`;
  };
  const parts = groups.map(
    ({ title, articles }) => `<section><h2>${escaped(title)}</h2><ul>${articles.map(item).join("")}</ul></section>`,
  );
  return `<nav class="contents" id="contents" aria-label="Contents">
      ${parts.join("\n      ")}
    </nav>`;
}
