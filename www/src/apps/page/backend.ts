/** Opens the page's renderer: in a worker, or on the page itself. */

import { PageError } from "../../engine/errors.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import { loadWhole, type WholeCore } from "../../engine/whole.ts";
import type { Backend, InitReply } from "../../host/protocol.ts";
import { RenderHost } from "../../host/render-host.ts";
import { backendOf, type Listener } from "../../host/worker-backend.ts";
import type { Answer, Init, Question } from "../page-worker/protocol.ts";

export type PageRenderHost = RenderHost<Question, Answer>;

export interface Engines {
  /** The page's own engine, for questions with an immediate answer. */
  readonly core: Promise<WholeCore>;
  /** The host of the renderer that grows and paints the rivers. */
  readonly renderHost: PageRenderHost;
}

/** After this many workers that did not answer, the page itself takes over. */
const MOST_LOST = 2;

const NOBODY = { hear: () => {}, moved: () => {} };

/**
 * Loads the engine, and opens a renderer meanwhile. The engine is fetched and compiled once: the worker's script is
 * requested at once, and the worker gets the module that the page has compiled.
 */
export function openEngines(): Engines {
  const module = new Promise<WebAssembly.Module>((done, failed) => {
    loadWhole(undefined, done).catch(failed);
  });
  // This does not load it again.
  const core = loadWhole();
  const renderHost = new RenderHost(opener(core, module));
  // A client without a river enters, so that a renderer is opened now. A failure is reported to the client with the
  // first river.
  renderHost.enter(NOBODY).catch(() => {});
  return { core, renderHost };
}

/**
 * Returns a function that opens a worker, or after too many failures a renderer on the page. It does not wait until the
 * worker is open, since the first picture would have to wait as well. A worker that is refused later counts as lost:
 * the river is handed over again, with another canvas.
 */
function opener(
  core: Promise<WholeCore>,
  module: Promise<WebAssembly.Module>,
): (listener: Listener<Answer>) => Promise<Backend<Question>> {
  let hopes = "transferControlToOffscreen" in HTMLCanvasElement.prototype ? MOST_LOST : 0;
  return async (listener) => {
    const worker = hopes > 0 ? await begin(module) : undefined;
    if (!worker) return openPageBackend(listener, await core);
    const giveUp = (left: number): void => {
      hopes = left;
      listener.lost();
    };
    return handOver(worker, await module, { ...listener, lost: () => giveUp(hopes - 1) }, () => giveUp(0));
  };
}

/**
 * Starts a worker, and returns it when the module to hand over is compiled; nothing if the worker was refused by then.
 */
async function begin(module: Promise<WebAssembly.Module>): Promise<Worker | undefined> {
  let worker: Worker | undefined;
  try {
    const begun: EarlyWorker =
      earlyWorker() ?? new Worker(new URL("../page-worker/page-worker.ts", import.meta.url), { type: "module" });
    worker = begun;
    const refused = new Promise<never>((_, refuse) => {
      begun.onerror = refuse;
      if (begun.isRefused) refuse();
    });
    await Promise.race([module, refused]);
    return worker;
  } catch {
    worker?.terminate();
    return;
  }
}

/** A worker that build/preload.ts started from the built page before this script was loaded. */
interface EarlyWorker extends Worker {
  isRefused?: boolean;
}

/** Takes the early worker, which is there only the first time. */
function earlyWorker(): EarlyWorker | undefined {
  const place = globalThis as { earlyWorker?: EarlyWorker | undefined } & typeof globalThis;
  const worker = place.earlyWorker;
  place.earlyWorker = undefined;
  return worker;
}

function handOver(
  worker: Worker,
  engine: WebAssembly.Module,
  listener: Listener<Answer>,
  refused: () => void,
): Backend<Question> {
  let isOpen = false;
  worker.addEventListener("message", ({ data }: MessageEvent<InitReply>) => {
    if (data.is === "open") isOpen = true;
    if (data.is === "shut") refused();
  });
  worker.postMessage({ engine } satisfies Init);
  return backendOf<Question, Answer>(worker, {
    ...listener,
    collapsed: (message) => (isOpen ? listener.collapsed(message) : refused()),
  });
}

/** Opens the renderer on the page itself, whose script most visitors never need. */
async function openPageBackend({ tell }: Listener<Answer>, core: WholeCore): Promise<Backend<Question>> {
  const { open } = await limited(SCRIPT_MS, "its script", importPageBackend);
  return open(core, tell);
}

/**
 * Imports the script. The page's script and engine have arrived before, so if this one fails the server has most likely
 * replaced it.
 */
async function importPageBackend(): Promise<typeof import("../page-worker/page-backend.ts")> {
  try {
    return await import("../page-worker/page-backend.ts");
  } catch (error) {
    throw new PageError("file-missing", String(error));
  }
}
