/**
 * The page's side of a renderer in a worker: opens it, watches it while an answer is due, and gives it up when none
 * comes.
 */

import { PageError } from "../engine/page-error.ts";
import { limited, type Watch, WORKER_SILENCE_MS, watch } from "../engine/time-limits.ts";
import type { Backend, InitReply, Ping, Pong, Report } from "./protocol.ts";

export interface Listener<Answer> {
  tell(report: Report<Answer>): void;
  /** Called when the backend as a whole has failed. */
  collapsed(message: string): void;
  /** Called when the backend no longer answers, so that it is closed and another opened. */
  lost(): void;
}

/** After this many workers that did not answer, the page itself takes over. */
const MOST_LOST = 2;
let lost = 0;

/**
 * Opens a worker, if the browser and the page's policy allow one with a canvas. `init` is its first message, which says
 * where the engine is. Returns nothing on failure: then the page itself is tried, and reports what is wrong.
 */
export async function openWorker<Question, Answer>(
  begin: () => Worker | Promise<Worker>,
  init: object,
  listener: Listener<Answer>,
): Promise<Backend<Question> | undefined> {
  if (lost >= MOST_LOST || !("transferControlToOffscreen" in HTMLCanvasElement.prototype)) return;
  let worker: Worker | undefined;
  try {
    worker = await begin();
    await handshake(worker, init);
    return backendOf(worker, listener);
  } catch (thrown) {
    if (thrown instanceof PageError) lost++;
    worker?.terminate();
    return;
  }
}

/**
 * Waits until the worker has the engine. A refused worker fires an error, and an engine that does not arrive is
 * reported in an answer; an empty script, or one that hangs, says nothing at all.
 */
function handshake(worker: Worker, init: object): Promise<void> {
  const opened = (heard: () => void): Promise<void> =>
    new Promise((done, failed) => {
      worker.onmessage = ({ data: { is } }: MessageEvent<InitReply>) =>
        is === "coming" ? heard() : is === "open" ? done() : failed();
      worker.onerror = failed;
      worker.postMessage(init);
    });
  return limited(WORKER_SILENCE_MS, "the worker", opened);
}

/** A message from an open worker. No long silence follows a report. */
type Said<Answer> = (Report<Answer> & { silenceMs?: undefined }) | Pong;

/** Wraps a worker that has the engine, or will have it, as a backend. */
export function backendOf<Question, Answer>(worker: Worker, listener: Listener<Answer>): Backend<Question> {
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
  worker.onmessage = ({ data }: MessageEvent<Said<Answer>>) => {
    watched?.heard(data.silenceMs);
    if (data.is !== "alive") listener.tell(data);
    else if (!data.isAtWork && data.id === commands) rest();
  };
  worker.onerror = ({ message }) => listener.collapsed(message);
  return {
    isReplaceable: true,
    take(command) {
      commands++;
      // Only while an answer is due, so that the worker of a page with finished rivers sleeps.
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
