/** Opens the renderer of widgets: in a worker, or on the page itself. */

import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import type { Backend } from "../../host/protocol.ts";
import { RenderHost } from "../../host/render-host.ts";
import { type Listener, openWorker } from "../../host/worker-backend.ts";
import type { Init, Question } from "./protocol.ts";

export async function openBackend(listener: Listener<Blob>, init: Init): Promise<Backend<Question>> {
  return (await openWorker(begin, init, listener)) ?? openPageBackend(listener, init);
}

/** One renderer for all widgets of a page. */
export const renderHost = new RenderHost(openBackend);

async function openPageBackend({ tell }: Listener<Blob>, init: Init): Promise<Backend<Question>> {
  const { open } = await importPageBackend();
  return open(tell, init);
}

/** Imports the renderer for the page itself, which most pages never need. */
export function importPageBackend(): Promise<typeof import("./page-backend.ts")> {
  return limited(SCRIPT_MS, "its script", () => import("./page-backend.ts"));
}

function begin(): Worker {
  try {
    return new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  } catch {
    return beginFromElsewhere();
  }
}

/** Starts a worker whose script is on another origin: a small worker on the page's origin imports it. */
function beginFromElsewhere(): Worker {
  const address = new URL(/* @vite-ignore */ "./worker.js", import.meta.url).href;
  const lines = new Blob([`import ${JSON.stringify(address)}`], { type: "text/javascript" });
  const url = URL.createObjectURL(lines);
  const worker = new Worker(url, { type: "module" });
  worker.addEventListener("message", () => URL.revokeObjectURL(url), { once: true });
  return worker;
}
