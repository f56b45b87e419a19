/**
 * The style sheet of all widgets. It is constructed, so that a page's policy against inline styles does not affect it.
 */

import css from "./sheet.css?inline";

let sheet: CSSStyleSheet | undefined;

export function sharedSheet(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
  }
  return sheet;
}
