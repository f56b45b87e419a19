/**
 * Scripts in a page that run before anything else. They are after its character set, which must be near its beginning,
 * and before its style sheets: a script after those would wait for them, and the rest of the page for the script.
 */

const PLACE = "<title>";

/** Adds an early script to a page, after those that it has. */
export function withEarlyScript(html: string, script: string): string {
  if (!html.includes(PLACE)) throw new Error(`a page has no ${PLACE} to put an early script before`);
  // A function, since a replacement text would interpret some characters.
  return html.replace(PLACE, () => `<script>${script}</script>\n    ${PLACE}`);
}
