/** The two places that the page's renderer can run in: a worker, and the page itself. */

import { PageError } from "../../engine/errors.ts";
import { type FullCore, loadFull } from "../../engine/full.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import type { Backend, InitReply } from "../../host/protocol.ts";
import { RenderHost } from "../../host/render-host.ts";
import { backendOf, type Listener } from "../../host/worker-backend.ts";
import type { Answer, Init, Question } from "../page-worker/protocol.ts";

export type PageRenderHost = RenderHost<Question, Answer>;

export interface Engines {
  /** The page's own engine, for what is asked of it at once. */
  readonly core: Promise<FullCore>;
  /** Where the rivers are grown and painted. */
  readonly renderHost: PageRenderHost;
}

/** After so many workers that did not answer, the page itself takes over: the next would hardly do better. */
const MOST_LOST = 2;

const NOBODY = { hear: () => {}, moved: () => {} };

/**
 * Loads the engine, and opens a renderer meanwhile. The engine is fetched and compiled once: the worker, whose script is asked for at
 * once, is handed what the page has compiled.
 */
export function openEngines(): Engines {
  const module = new Promise<WebAssembly.Module>((done, failed) => {
    loadFull(undefined, done).catch(failed);
  });
  // The same as above: it is loaded once.
  const core = loadFull();
  const renderHost = new RenderHost(opener(core, module));
  // Somebody enters before there is a river, so that there is a renderer by then. Whoever brings the river is told what went wrong.
  renderHost.enter(NOBODY).catch(() => {});
  return { core, renderHost };
}

/**
 * Opens a worker as long as there is hope, and does not wait until that says that it is open: the first picture would wait as well. One
 * that is refused later is as good as one that answers no more: the river is handed over again, with another canvas.
 */
function opener(
  core: Promise<FullCore>,
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

/** A worker, as soon as there is something to hand over. One that is refused says so by an error, which may come before that. */
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

/** A worker that a script in the built page has begun, before this one had come: build/preload.ts. */
interface EarlyWorker extends Worker {
  isRefused?: boolean;
}

/** The first time. */
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

/** What most visitors never need. */
async function openPageBackend({ tell }: Listener<Answer>, core: FullCore): Promise<Backend<Question>> {
  const { open } = await limited(SCRIPT_MS, "its script", importPageBackend);
  return open(core, tell);
}

/** Comes after the page's script and its engine have arrived: if it does not, the server has most likely replaced it. */
async function importPageBackend(): Promise<typeof import("../page-worker/page-backend.ts")> {
  try {
    return await import("../page-worker/page-backend.ts");
  } catch (error) {
    throw new PageError("file-missing", String(error));
  }
}
