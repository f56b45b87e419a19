/**
 * Addresses for crawlers. Everything else in the site is relative, so that it works on any host; but who shows a card with the
 * page's picture wants whole addresses. RIVERSEED_SITE says, at build time, where the site will be.
 */

import type { Plugin } from "vite";

const IMAGE = /(<meta (?:property="og:image"|name="twitter:image") content=")([^"]*)/g;

export function wholeAddresses(site: string | undefined): Plugin {
  return {
    name: "whole-addresses",
    apply: "build",
    transformIndexHtml: { order: "post", handler: (html) => (site === undefined ? html : completed(html, site)) },
  };
}

/** The page with its picture's whole address, and its own. */
export function completed(html: string, site: string): string {
  const base = new URL(baseOf(site));
  return html
    .replace(IMAGE, (_, before: string, address: string) => before + new URL(address, base).href)
    .replace(/(?=<meta property="og:image")/, `<meta property="og:url" content="${base.href}" />\n    `)
    .replace(/(?=<meta property="og:url")/, `<link rel="canonical" href="${base.href}" />\n    `);
}

/** The site's address, as a folder. */
export function baseOf(site: string): string {
  return site.endsWith("/") ? site : `${site}/`;
}
