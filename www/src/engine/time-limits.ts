/** How long is waited for what may never answer, all of it in one place, and the watch that counts. */

import { PageError } from "./errors.ts";

/**
 * A download that brings no byte for so long is given up. Bytes put the end off, however few: a slow line is waited for, a dead
 * one is not. Browsers themselves wait for minutes.
 */
export const DOWNLOAD_SILENCE_MS = 10_000;
/**
 * A worker that shows no sign of life for so long is given up: while it starts, and later while an answer is due. Its longest
 * step takes a tenth of a second.
 */
export const WORKER_SILENCE_MS = 10_000;
/**
 * The one exception is announced beforehand: a picture for a file is painted in one step. 67 million pixels, the most there may be, take
 * a desk computer a few seconds and an old phone half a minute and more.
 */
export const PAINTING_SILENCE_MS = 120_000;
/** A script that is fetched late is given up after this time: how far it has come cannot be seen, so slow lines have twice the time. */
export const SCRIPT_MS = 20_000;

/** The watch counts ticks and does not compare times: a machine that slept wakes up one tick later. */
const TICK_MS = 1000;

export interface Watch {
  /** There was a sign of life: the time starts over, and runs for `limitMs` until the next one. */
  heard(limitMs?: number): void;
  end(): void;
}

/** Calls `silent`, once, when nothing has been heard for so long; until then `asks` at every tick. */
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

/** What some work gives, or `wasm-timeout` once it has shown no progress for so long. */
export function limited<T>(limitMs: number, what: string, work: (heard: () => void) => Promise<T>): Promise<T> {
  return new Promise((done, failed) => {
    const { heard, end } = watch(limitMs, () => failed(timeout(what, limitMs)));
    work(heard).then(done, failed).finally(end);
  });
}

function timeout(what: string, limitMs: number): PageError {
  return new PageError("wasm-timeout", `nothing came from ${what} for ${limitMs / 1000} seconds`);
}
