/**
 * Makes files that take long, each in its own worker, which ends with it. So nothing else waits for the file, it can be
 * cancelled at any time, and the memory of the largest pictures is given back. If workers are refused, the page makes
 * it.
 */

import { turn } from "../../../browser/turn.ts";
import { PageError } from "../../../engine/errors.ts";
import { limited, SCRIPT_MS, WORKER_SILENCE_MS } from "../../../engine/time-limits.ts";
import type { Order, Said } from "../../../files/order.ts";

/** A file in the making. */
export interface Making {
  /** The file; undefined if it was cancelled. */
  readonly file: Promise<Blob | undefined>;
  cancel(): void;
}

type Tell = (share: number) => void;

export function making(order: Order, tell: Tell): Making {
  const control = new AbortController();
  const { signal } = control;
  const cancelled = new Promise<undefined>((done) => signal.addEventListener("abort", () => done(undefined)));
  return { file: Promise.race([made(order, tell, signal), cancelled]), cancel: () => control.abort() };
}

async function made(order: Order, tell: Tell, signal: AbortSignal): Promise<Blob | undefined> {
  const worker = await opened(order.kind);
  if (signal.aborted) {
    worker?.terminate();
    return;
  }
  if (!worker) return madeHere(order, tell, signal);
  try {
    return await madeBy(worker, order, tell, signal);
  } finally {
    worker.terminate();
  }
}

/** Returns a worker that is ready, or nothing if it is refused. */
async function opened(kind: Order["kind"]): Promise<Worker | undefined> {
  let worker: Worker | undefined;
  try {
    const begun =
      kind === "animation"
        ? new Worker(new URL("../../file-worker/animation-worker.ts", import.meta.url), { type: "module" })
        : new Worker(new URL("../../file-worker/picture-worker.ts", import.meta.url), { type: "module" });
    worker = begun;
    await limited(
      WORKER_SILENCE_MS,
      "the worker",
      () =>
        new Promise<unknown>((done, refused) => {
          begun.onmessage = done;
          begun.onerror = refused;
        }),
    );
    return worker;
  } catch {
    worker?.terminate();
    return;
  }
}

function madeBy(worker: Worker, order: Order, tell: Tell, signal: AbortSignal): Promise<Blob | undefined> {
  return new Promise((done, failed) => {
    signal.addEventListener("abort", () => done(undefined));
    worker.onmessage = ({ data }: MessageEvent<Said>) => {
      if (data.is === "at") tell(data.share);
      if (data.is === "made") done(data.file);
      if (data.is === "failed") failed(new PageError(data.code, data.message));
    };
    worker.onerror = ({ message }) => failed(new PageError("panic", message));
    worker.postMessage(order);
  });
}

/** Makes a file on the page itself, in slices. The script for it is fetched now. */
async function madeHere(order: Order, tell: Tell, signal: AbortSignal): Promise<Blob | undefined> {
  const { makeHere } = await limited(SCRIPT_MS, "its script", () => import("../../file-worker/page-maker.ts"));
  const pause = async (): Promise<void> => {
    await turn();
    signal.throwIfAborted();
  };
  try {
    return await makeHere(order, { tell, pause });
  } catch (error) {
    if (signal.aborted) return;
    throw error;
  }
}
