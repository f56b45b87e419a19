/** Writes the files for crawlers: robots.txt and, if the site's address is known, a sitemap. */

import type { Plugin } from "vite";
import { addressOf, contents } from "./docs/contents.ts";
import { FOLDER } from "./docs/frame.ts";
import { filesOf } from "./gallery/pages.ts";
import { recipes } from "./gallery/recipes.ts";
import { baseOf } from "./social.ts";

export function crawlers(site: string | undefined): Plugin {
  return {
    name: "crawlers",
    apply: "build",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: "robots.txt", source: robots(site) });
      if (site !== undefined) this.emitFile({ type: "asset", fileName: "sitemap.xml", source: sitemap(site) });
    },
  };
}

export function robots(site: string | undefined): string {
  const map = site === undefined ? "" : `\nSitemap: ${baseOf(site)}sitemap.xml\n`;
  return `User-agent: *\nAllow: /\n${map}`;
}

/** Writes the sitemap, with addresses escaped for XML. */
export function sitemap(site: string): string {
  const documents = contents().flatMap(({ articles }) => articles.map(({ source }) => addressOf(source)));
  const pages = [
    "",
    "gallery/",
    ...recipes.map(({ slug }) => `gallery/${filesOf(slug).page}`),
    ...["", ...documents].map((address) => `${FOLDER}/${address}`),
  ];
  const base = baseOf(site).replaceAll("&", "&amp;");
  return `<?xml version="1.0" encoding="UTF-8"?>
<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">
${pages.map((page) => `  <url><loc>${base}${page}</loc></url>`).join("\n")}
</urlset>
`;
}
