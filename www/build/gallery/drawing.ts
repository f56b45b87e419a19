/**
 * Draws maps during the build, on all cores, with the page's engine. Pictures are kept, since the same link, engine and
 * code make the same picture.
 */

import { readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { Kept } from "./kept.ts";
import type { Shot } from "./shots.ts";

const DRAWER = new URL("../../scripts/draw-maps.mjs", import.meta.url);
/** The files on which pictures depend besides their links. The lock names the encoder, and what sets titles. */
const MAKERS = ["../../pkg-engine/riverseed_engine_bg.wasm", "../../scripts/draw-maps.mjs", "../../package-lock.json"];

/** Pictures of one map. */
export interface Order {
  readonly link: string;
  readonly shots: readonly Shot[];
}

type Answer = { files: Uint8Array[] } | { error: string };

/** Returns the files of all orders, in the same order. */
export async function drawAll(orders: readonly Order[]): Promise<Uint8Array[][]> {
  const kept = new Kept(
    process.env["RIVERSEED_CACHE"],
    MAKERS.map((file) => readFileSync(new URL(file, import.meta.url))),
  );
  const files = orders.map((order) => keptFor(order, kept));
  const missing = orders.map((_, i) => i).filter((i) => files[i] === undefined);
  const threads = Math.min(availableParallelism(), missing.length);
  await Promise.all(Array.from({ length: threads }, () => drawMissing(missing, orders, kept, files)));
  return files.map((made) => made ?? []);
}

/** Draws missing orders in a thread until none is left. */
async function drawMissing(
  missing: number[],
  orders: readonly Order[],
  kept: Kept,
  files: (Uint8Array[] | undefined)[],
): Promise<void> {
  const worker = new Worker(DRAWER);
  try {
    for (let i = missing.shift(); i !== undefined; i = missing.shift()) {
      const order = orders[i];
      if (!order) continue;
      const made = await drawn(worker, order);
      for (const [k, file] of made.entries()) kept.keep(partsOf(order.link, order.shots[k]), file);
      files[i] = made;
    }
  } finally {
    await worker.terminate();
  }
}

function drawn(worker: Worker, order: Order): Promise<Uint8Array[]> {
  return new Promise((done, failed) => {
    worker.removeAllListeners();
    worker.once("error", failed);
    worker.once("message", (answer: Answer) => {
      if ("error" in answer) failed(new Error(answer.error));
      else done(answer.files);
    });
    worker.postMessage(order);
  });
}

function keptFor({ link, shots }: Order, kept: Kept): Uint8Array[] | undefined {
  const files = shots.map((shot) => kept.file(partsOf(link, shot)));
  return files.every((file) => file !== undefined) ? files : undefined;
}

function partsOf(link: string, shot: Shot | undefined): string[] {
  return [link, JSON.stringify(shot)];
}
