/** The two places that the renderer of widgets can run in: a worker, and the page itself. */

import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import type { Backend } from "../../host/protocol.ts";
import { RenderHost } from "../../host/render-host.ts";
import { type Listener, openWorker } from "../../host/worker-backend.ts";
import type { Init, Question } from "./protocol.ts";

export async function openBackend(listener: Listener<Blob>, wasmUrl: string | undefined): Promise<Backend<Question>> {
  return (await openWorker(begin, { wasmUrl } satisfies Init, listener)) ?? openPageBackend(listener, wasmUrl);
}

/** One renderer for all widgets of a page. */
export const renderHost = new RenderHost(openBackend);

async function openPageBackend({ tell }: Listener<Blob>, wasmUrl: string | undefined): Promise<Backend<Question>> {
  const { open } = await importPageBackend();
  return open(tell, wasmUrl);
}

/** What most pages never need. */
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

/** A worker has to come from the page's own origin, so one of two lines does, and imports the real one. */
function beginFromElsewhere(): Worker {
  const address = new URL(/* @vite-ignore */ "./worker.js", import.meta.url).href;
  const lines = new Blob([`import ${JSON.stringify(address)}`], { type: "text/javascript" });
  const url = URL.createObjectURL(lines);
  const worker = new Worker(url, { type: "module" });
  worker.addEventListener("message", () => URL.revokeObjectURL(url), { once: true });
  return worker;
}
