/**
 * Scripts in a page that run before anything else. They stand behind its character set, which must be near its beginning, and before its
 * style sheets: a script behind those would wait for them, and the rest of the page for the script.
 */

const PLACE = "<title>";

/** The page with one more of them, behind those that it has. */
export function withEarlyScript(html: string, script: string): string {
  if (!html.includes(PLACE)) throw new Error(`a page has no ${PLACE} for an early script to stand before`);
  // A function, since in a text some signs would mean something.
  return html.replace(PLACE, () => `<script>${script}</script>\n    ${PLACE}`);
}
