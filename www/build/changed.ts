/**
 * Reports missing files. A site that is half uploaded has the HTML of one build and the files of another. Then the
 * page's own script may be missing, so a small script in the HTML shows a message.
 */

import type { Plugin } from "vite";
import { withEarlyScript } from "./early.ts";

/** The message's element in index.html. */
const NOTE = 'id="changed"';

export function tellsOfMissingFiles(page: string): Plugin {
  return {
    name: "tells-of-missing-files",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(html, { path }) {
        if (path.slice(1) !== page) return html;
        if (!html.includes(NOTE)) throw new Error(`${page} has no element with ${NOTE}`);
        return withEarlyScript(html, SCRIPT);
      },
    },
  };
}

/**
 * The script. An error event does not say why a file failed, so the server is asked for the file again: the site has
 * changed only if the server does not have the file, or sends a page in its place. If the server cannot be reached or a
 * browser extension blocks the file, the page's other text stays. Once the page's own script runs, that reports missing
 * scripts: src/apps/page/begin.ts. A style sheet may be found missing after that.
 */
const SCRIPT = `addEventListener("error", async ({ target }) => {
  const isScript = target instanceof HTMLScriptElement;
  if (!isScript && !(target instanceof HTMLLinkElement && /^(stylesheet|modulepreload)$/.test(target.rel))) return;
  if (globalThis.hasPageBegun && target.rel !== "stylesheet") return;
  const answer = await fetch(isScript ? target.src : target.href, { method: "HEAD", cache: "no-store" }).catch(() => {});
  if (!answer || (answer.ok && !/html/.test(answer.headers.get("content-type")))) return;
  if (document.readyState === "loading") await new Promise((done) => addEventListener("DOMContentLoaded", done));
  document.getElementById("facade").hidden = true;
  document.getElementById("changed").hidden = false;
  document.getElementById("load-again").onclick = () => location.reload();
}, true);`;
