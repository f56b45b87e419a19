/**
 * Starts the worker that grows the rivers and requests the engine as soon as the page is loaded, without waiting for
 * the page's script: on a slow line two waits become one. The worker itself is started, since browsers fetch a
 * preloaded script again for a worker, and a worker takes longer to start than the page's script to arrive. The engine
 * is requested exactly as in src/engine/wasm-module.ts, or the browser would fetch it twice. On a page with a poster
 * the page's script requests the engine, so that the poster is seen first. If the line is slow, the engine is requested
 * after a while with low priority.
 */

import type { Plugin } from "vite";
import { withEarlyScript } from "./early.ts";

const ENGINE = "riverseed_engine_bg.wasm";
/** The time after which a line is slow if the page's script has not arrived. */
const SLOW_MS = 400;
const WORKER = /page-worker-[\w-]+\.js$/;

/** Adds the script. The plugin must come after the poster's, whose script says whether there is a poster. */
export function preloadEngine(...pages: readonly string[]): Plugin {
  return {
    name: "preload-engine",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(html, { bundle = {}, path }) {
        if (!pages.includes(path.slice(1))) return html;
        if (!html.includes("dataset.withoutPoster"))
          throw new Error(`${path}: no script has said whether there is a poster`);
        const files = Object.values(bundle);
        const engine = files.find((file) => file.type === "asset" && file.names.includes(ENGINE));
        const worker = files.find(({ fileName }) => WORKER.test(fileName));
        if (!engine || !worker) throw new Error(`${path}: the build has no ${ENGINE} or no worker to load early`);
        return withEarlyScript(html, [beginsWorker(worker.fileName), asksFor(engine.fileName)].join("\n"));
      },
    },
  };
}

/**
 * Writes the script that starts the worker, unless the browser cannot hand a canvas to it. src/apps/page/backend.ts
 * takes it over, and learns from `isRefused` if it was refused before.
 */
function beginsWorker(fileName: string): string {
  return `if ("transferControlToOffscreen" in HTMLCanvasElement.prototype) try {
  const worker = (globalThis.earlyWorker = new Worker("./${fileName}", { type: "module" }));
  worker.onerror = () => { worker.isRefused = true; };
} catch {}`;
}

/** Writes the script that requests the engine. src/apps/page/begin.ts clears the timer when it runs. */
function asksFor(fileName: string): string {
  const link = `{ rel: "preload", as: "fetch", type: "application/wasm", crossOrigin: "", href: "./${fileName}" }`;
  return `{
  const ask = (fetchPriority) => document.head.append(Object.assign(document.createElement("link"), { fetchPriority }, ${link}));
  if ("withoutPoster" in document.documentElement.dataset) ask("auto");
  else globalThis.engineTimer = setTimeout(ask, ${SLOW_MS}, "low");
}`;
}
