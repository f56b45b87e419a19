/** All the time limits for answers that may never come, and the watch that counts them. */

import { PageError } from "./page-error.ts";

/**
 * A download that brings no byte for this time is given up. Any byte restarts the time, so that a slow line is waited
 * for and a dead one is not. Browsers themselves wait for minutes.
 */
export const DOWNLOAD_SILENCE_MS = 10_000;
/**
 * A worker that shows no sign of life for this time is given up: while it starts, and later while an answer is due. Its
 * longest step takes a tenth of a second.
 */
export const WORKER_SILENCE_MS = 10_000;
/**
 * The limit while a picture for a file is painted. That is one long step, which the worker announces beforehand: 67
 * million pixels, the most there may be, take a desk computer a few seconds and an old phone more than half a minute.
 */
export const PAINTING_SILENCE_MS = 120_000;
/**
 * A script that is fetched late is given up after this time. Its progress cannot be seen, so slow lines get twice the
 * time.
 */
export const SCRIPT_MS = 20_000;

/** The watch counts ticks and does not compare times: for a machine that slept, only one tick has passed. */
const TICK_MS = 1000;

export interface Watch {
  /** Notes a sign of life: the time starts over, and the next one is due within `limitMs`. */
  heard(limitMs?: number): void;
  end(): void;
}

/** Calls `silent`, once, when nothing has been heard for `limitMs`; until then calls `asks` at every tick. */
export function watch(limitMs: number, silent: () => void, asks?: () => void): Watch {
  let ticks = 0;
  let limit = limitMs;
  const end = (): void => clearInterval(timer);
  const timer = setInterval(() => {
    if (++ticks * TICK_MS < limit) return asks?.();
    end();
    silent();
  }, TICK_MS);
  return {
    heard: (next = limitMs) => {
      ticks = 0;
      limit = next;
    },
    end,
  };
}

/** Returns the result of some work, or fails with `wasm-timeout` if it shows no progress for `limitMs`. */
export function limited<T>(limitMs: number, what: string, work: (heard: () => void) => Promise<T>): Promise<T> {
  return new Promise((done, failed) => {
    const { heard, end } = watch(limitMs, () => failed(timeout(what, limitMs)));
    work(heard).then(done, failed).finally(end);
  });
}

function timeout(what: string, limitMs: number): PageError {
  return new PageError("wasm-timeout", `nothing came from ${what} for ${limitMs / 1000} seconds`);
}
