/**
 * Writes absolute addresses for crawlers. Everything else in the site is relative, so that it works on any host, but
 * cards with the page's picture need absolute addresses. RIVERSEED_SITE gives the site's address at build time.
 */

import type { Plugin } from "vite";

/** The stand-in for the address of the site in what readers paste. */
export const SOME_SITE = "https://example.org/riverseed/";

const IMAGE = /(<meta (?:property="og:image"|name="twitter:image") content=")([^"]*)/g;

export function wholeAddresses(site: string | undefined): Plugin {
  return {
    name: "whole-addresses",
    apply: "build",
    transformIndexHtml: { order: "post", handler: (html) => (site === undefined ? html : completed(html, site)) },
  };
}

/** Adds the absolute addresses of the page and its picture. */
export function completed(html: string, site: string): string {
  const base = new URL(baseOf(site));
  return html
    .replace(IMAGE, (_, before: string, address: string) => before + new URL(address, base).href)
    .replace(/(?=<meta property="og:image")/, `<meta property="og:url" content="${base.href}" />\n    `)
    .replace(/(?=<meta property="og:url")/, `<link rel="canonical" href="${base.href}" />\n    `);
}

/** Returns the site's address with a slash at the end. */
export function baseOf(site: string): string {
  return site.endsWith("/") ? site : `${site}/`;
}
