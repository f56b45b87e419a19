/** The media query of a reader who prefers dark pages. Alone, since the element needs nothing else that is about styles. */
export const DARK_PAGES = "(prefers-color-scheme: dark)";
