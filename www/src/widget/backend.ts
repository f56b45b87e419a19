/** The two places that the renderer can run in: a worker, and the page itself. */

import { PageError } from "../engine/errors.ts";
import { limited, SCRIPT_MS, type Watch, WORKER_SILENCE_MS, watch } from "../engine/time-limits.ts";
import type { Backend, Init, InitReply, Ping, Pong, Report } from "./protocol.ts";

export interface Listener {
  tell(report: Report): void;
  /** The backend as a whole has failed. */
  collapsed(message: string): void;
  /** The backend no longer answers: it is to be closed, and another opened. */
  lost(): void;
}

/** After this number of workers that did not answer, the page itself takes over: the next would hardly do better. */
const MOST_LOST = 2;
let lost = 0;

/** A worker if the browser and the page's policy allow one with a canvas, otherwise the page itself. */
export async function openBackend(listener: Listener, wasmUrl: string | undefined): Promise<Backend> {
  return (await openWorkerBackend(listener, wasmUrl)) ?? openPageBackend(listener, wasmUrl);
}

async function openPageBackend({ tell }: Listener, wasmUrl: string | undefined): Promise<Backend> {
  const { open } = await importPageBackend();
  return open(tell, wasmUrl);
}

/** What most pages never need. */
export function importPageBackend(): Promise<typeof import("./page-backend.ts")> {
  return limited(SCRIPT_MS, "its script", () => import("./page-backend.ts"));
}

/** Nothing if the browser gives none: whatever the reason, the page itself is tried next and says what is wrong. */
async function openWorkerBackend(listener: Listener, wasmUrl: string | undefined): Promise<Backend | undefined> {
  if (lost >= MOST_LOST || !("transferControlToOffscreen" in HTMLCanvasElement.prototype)) return;
  let worker: Worker | undefined;
  try {
    worker = begin();
    await handshake(worker, { wasmUrl });
    return backendOf(worker, listener);
  } catch (thrown) {
    if (thrown instanceof PageError) lost++;
    worker?.terminate();
    return;
  }
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

/**
 * Waits until the worker has the engine. A refused worker says so by an error, an engine that does not arrive by an answer; an
 * empty script, or one that hangs, says nothing at all.
 */
function handshake(worker: Worker, init: Init): Promise<void> {
  const opened = (heard: () => void): Promise<void> =>
    new Promise((done, failed) => {
      worker.onmessage = ({ data: { is } }: MessageEvent<InitReply>) =>
        is === "coming" ? heard() : is === "open" ? done() : failed();
      worker.onerror = failed;
      worker.postMessage(init);
    });
  return limited(WORKER_SILENCE_MS, "the worker", opened);
}

/** What a worker says once it is open; of reports alone no silence follows. */
type Said = (Report & { silenceMs?: undefined }) | Pong;

function backendOf(worker: Worker, listener: Listener): Backend {
  let commands = 0;
  let watched: Watch | undefined;
  const ping = (): void => worker.postMessage({ id: commands, do: "ping" } satisfies Ping);
  const rest = (): void => {
    watched?.end();
    watched = undefined;
  };
  const lose = (): void => {
    lost++;
    listener.lost();
  };
  worker.onmessage = ({ data }: MessageEvent<Said>) => {
    watched?.heard(data.silenceMs);
    if (data.is !== "alive") listener.tell(data);
    else if (!data.isAtWork && data.id === commands) rest();
  };
  worker.onerror = ({ message }) => listener.collapsed(message);
  return {
    isReplaceable: true,
    take(command) {
      commands++;
      // Only while an answer is due: a page whose rivers are finished lets its worker sleep.
      watched ??= watch(WORKER_SILENCE_MS, lose, ping);
      if (command.do === "open") {
        const canvas = (command.canvas as HTMLCanvasElement).transferControlToOffscreen();
        worker.postMessage({ ...command, canvas }, [canvas]);
      } else worker.postMessage(command);
    },
    close() {
      rest();
      worker.terminate();
    },
  };
}
