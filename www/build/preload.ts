/**
 * The engine is asked for as soon as the page is there, and not only when its script has arrived and been read: on a slow line
 * two waits become one. Asked for just as src/engine/wasm-module.ts does, or the browser would fetch it twice.
 *
 * The worker that grows the rivers begins then, too: what a browser preloads it would fetch again for a worker, and a worker takes longer
 * to begin than the page's script to come.
 */

import type { HtmlTagDescriptor, Plugin } from "vite";

const ENGINE = "riverseed_full_bg.wasm";
const WORKER = /page-worker-[\w-]+\.js$/;

export function preloadEngine(...pages: readonly string[]): Plugin {
  return {
    name: "preload-engine",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle = {}, path }) {
        if (!pages.includes(path.slice(1))) return [];
        const files = Object.values(bundle);
        const engine = files.find((file) => file.type === "asset" && file.names.includes(ENGINE));
        const worker = files.find(({ fileName }) => WORKER.test(fileName));
        if (!engine || !worker) throw new Error(`${path}: the build has no ${ENGINE} or no worker to ask for early`);
        return [linkTo(engine.fileName), scriptThatBegins(worker.fileName)];
      },
    },
  };
}

function linkTo(fileName: string): HtmlTagDescriptor {
  const attrs = { rel: "preload", as: "fetch", type: "application/wasm", crossorigin: true, href: `./${fileName}` };
  return { tag: "link", attrs, injectTo: "head" };
}

/** src/page/backend.ts takes it over, and hears whether it was refused before that. Where no canvas can be handed to it, there is none. */
function scriptThatBegins(fileName: string): HtmlTagDescriptor {
  const children = `if ("transferControlToOffscreen" in HTMLCanvasElement.prototype) try {
  const worker = (globalThis.earlyWorker = new Worker("./${fileName}", { type: "module" }));
  worker.onerror = () => { worker.isRefused = true; };
} catch {}`;
  return { tag: "script", children, injectTo: "head" };
}
