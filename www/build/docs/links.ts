/** Finds where the links of a document lead in the built site. */

import { existsSync } from "node:fs";
import { join, posix } from "node:path";
import { filesOf } from "../gallery/pages.ts";
import { recipes } from "../gallery/recipes.ts";
import { SOME_SITE } from "../social.ts";
import type { Article } from "./article.ts";
import { addressOf, REPOSITORY, wayUp } from "./contents.ts";

/** Files of the repository that the site serves, by their addresses in it. */
const SERVED: Readonly<Record<string, string>> = { "www/examples/blog.html": "examples/blog.html" };
/** Pages of the site that documents lead to. */
const SITE = new Set([
  "",
  "embed.html",
  "examples/blog.html",
  "gallery/",
  "real-or-grown.html",
  ...recipes.map(({ slug }) => `gallery/${filesOf(slug).page}`),
]);

/** The target of a link: its address from the page, nothing if the site does not have it, or a fault. */
export type Target = { readonly href: string | undefined } | { readonly fault: string };

/** Finds the target of a link of a page, among all pages by their sources. */
export function targetOf(href: string, from: Article, all: ReadonlyMap<string, Article>): Target {
  const root = `${wayUp(addressOf(from.source))}../`;
  if (href.startsWith(SOME_SITE)) return onSite(href.slice(SOME_SITE.length), root);
  if (/^https?:\/\//.test(href)) return { href };
  if (/^[a-z][a-z0-9+.-]*:|^\/\/|^\//i.test(href)) return { fault: `${href} is neither relative nor https` };
  const [path = "", anchor] = href.split("#");
  const source = path === "" ? from.source : posix.join(posix.dirname(from.source), path);
  // Code hosts show a folder with its README.
  const article = all.get(source) ?? all.get(posix.join(source, "README.md"));
  if (!article) return besides(source, href, root);
  if (anchor !== undefined && !article.headings.some(({ id }) => id === anchor))
    return { fault: `${article.source} has no heading #${anchor}` };
  const address = article === from ? "" : `${wayUp(addressOf(from.source))}${addressOf(article.source)}`;
  return { href: anchor === undefined ? address || "#" : `${address}#${anchor}` };
}

function onSite(rest: string, root: string): Target {
  const page = rest.replace(/[?#].*/, "");
  return SITE.has(page) ? { href: root + rest } : { fault: `the site has no page ${page}` };
}

/** Finds what is no page: a file that the site serves, or one that only the repository has. */
function besides(source: string, href: string, root: string): Target {
  const served = SERVED[source];
  if (served !== undefined) return { href: root + served };
  if (source.startsWith("../") || !existsSync(join(REPOSITORY, source))) return { fault: `there is no ${href}` };
  return { href: undefined };
}
