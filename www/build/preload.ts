/**
 * The worker that grows the rivers begins as soon as the page is there, and the engine is asked for, and not only when the page's script
 * has arrived and been read: on a slow line two waits become one. What a browser preloads it would fetch again for a worker, and a worker
 * takes longer to begin than the page's script to come. The engine is asked for just as src/engine/wasm-module.ts does, or the browser
 * would fetch it twice. Where a poster stands for the map meanwhile it is left to that script, so that the poster is seen first; unless the
 * line is slow: then it is asked for after a while, behind all else.
 */

import type { Plugin } from "vite";
import { withEarlyScript } from "./early.ts";

const ENGINE = "riverseed_full_bg.wasm";
/** A page whose script is not there by then has a slow line. */
const SLOW_MS = 400;
const WORKER = /page-worker-[\w-]+\.js$/;

/** Comes after the poster, whose script says whether there is one. */
export function preloadEngine(...pages: readonly string[]): Plugin {
  return {
    name: "preload-engine",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(html, { bundle = {}, path }) {
        if (!pages.includes(path.slice(1))) return html;
        if (!html.includes("dataset.linked")) throw new Error(`${path}: no script has said whether there is a poster`);
        const files = Object.values(bundle);
        const engine = files.find((file) => file.type === "asset" && file.names.includes(ENGINE));
        const worker = files.find(({ fileName }) => WORKER.test(fileName));
        if (!engine || !worker) throw new Error(`${path}: the build has no ${ENGINE} or no worker to ask for early`);
        return withEarlyScript(html, [beginsWorker(worker.fileName), asksFor(engine.fileName)].join("\n"));
      },
    },
  };
}

/** src/apps/page/backend.ts takes it over, and hears whether it was refused before that. Where no canvas can be handed to it, there is none. */
function beginsWorker(fileName: string): string {
  return `if ("transferControlToOffscreen" in HTMLCanvasElement.prototype) try {
  const worker = (globalThis.earlyWorker = new Worker("./${fileName}", { type: "module" }));
  worker.onerror = () => { worker.isRefused = true; };
} catch {}`;
}

/** src/apps/page/page.ts takes the timer back once it is there. */
function asksFor(fileName: string): string {
  const link = `{ rel: "preload", as: "fetch", type: "application/wasm", crossOrigin: "", href: "./${fileName}" }`;
  return `{
  const ask = (fetchPriority) => document.head.append(Object.assign(document.createElement("link"), { fetchPriority }, ${link}));
  if ("linked" in document.documentElement.dataset) ask("auto");
  else globalThis.engineTimer = setTimeout(ask, ${SLOW_MS}, "low");
}`;
}
