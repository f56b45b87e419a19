/**
 * The engine is asked for as soon as the page is there, and not only when its script has arrived and been read: on a slow line
 * two waits become one. Asked for just as src/engine/wasm-module.ts does, or the browser would fetch it twice.
 */

import type { Plugin } from "vite";

const ENGINE = "riverseed_page_bg.wasm";

export function preloadEngine(...pages: readonly string[]): Plugin {
  return {
    name: "preload-engine",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle, path }) {
        if (!pages.includes(path.slice(1))) return [];
        const engine = Object.values(bundle ?? {}).find((file) => file.type === "asset" && file.names.includes(ENGINE));
        if (!engine) throw new Error(`${path}: the build has no ${ENGINE} to preload`);
        const attrs = {
          rel: "preload",
          as: "fetch",
          type: "application/wasm",
          crossorigin: true,
          href: `./${engine.fileName}`,
        };
        return [{ tag: "link", attrs, injectTo: "head" }];
      },
    },
  };
}
