/**
 * The media query of a reader who prefers dark pages. In its own file, since the element needs nothing else about
 * styles.
 */
export const DARK_PAGES = "(prefers-color-scheme: dark)";
