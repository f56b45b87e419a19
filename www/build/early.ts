/**
 * Scripts in a page that run before anything else: they stand behind its character set, and before its style sheets, for which a script
 * would wait, and with it all of the page behind it.
 */

const PLACE = "<title>";

/** The page with one more of them, behind those that it has. */
export function withEarlyScript(html: string, script: string): string {
  if (!html.includes(PLACE)) throw new Error(`a page has no ${PLACE} for an early script to stand before`);
  // A function, since in a text some signs would mean something.
  return html.replace(PLACE, () => `<script>${script}</script>\n    ${PLACE}`);
}
