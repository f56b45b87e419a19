/**
 * The stand-in for the site's own address in what readers paste. It is replaced during the build if the address is known, or else in
 * the browser, by the address that the reader has opened.
 */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import { baseOf, SOME_SITE } from "../social.ts";

/** Writes code as HTML, with the site's address in place of its stand-in, or marked so that the browser replaces it. */
export function codeWithSite(code: string, site: string | undefined): string {
  const address = site === undefined ? `<span data-site>${escaped(SOME_SITE)}</span>` : escaped(baseOf(site));
  return code.split(SOME_SITE).map(escaped).join(address);
}

/** Returns whether a paragraph only explains the stand-in: it is of no use once that is replaced. */
export function explainsStandIn(words: string): boolean {
  return words.startsWith(`${SOME_SITE} stands for `);
}
