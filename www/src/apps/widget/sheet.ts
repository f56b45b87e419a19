/** The style sheet of all widgets: a constructed one, so that a page's policy against inline styles does not concern it. */

import css from "./sheet.css?inline";

let sheet: CSSStyleSheet | undefined;

export function sharedSheet(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
  }
  return sheet;
}
