/**
 * Sets all of a visit's text in one family: on a slow line one face of the page's typeface may come in time for the
 * first frame and the other not, and browsers would then mix it with the reader's own serif until the next visit.
 */

import type { Plugin } from "vite";
import { withEarlyScript } from "./early.ts";

export function typefaces(...pages: readonly string[]): Plugin {
  return {
    name: "typefaces",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler: (html, { path }) => (pages.includes(path.slice(1)) ? withEarlyScript(html, DECIDES) : html),
    },
  };
}

/**
 * Decides once browsers have, a moment after the first frame: until then text without its face is not shown at all, and
 * from then on a face that comes is not used. The class is in src/style/base.css.
 */
const DECIDES = `requestAnimationFrame(() => setTimeout(() => {
  const faces = [...document.fonts].filter(({ family }) => family.includes("Garamond"));
  if (faces.some(({ status }) => status !== "loaded")) document.documentElement.classList.add("fallback-serif");
}, 100));`;
