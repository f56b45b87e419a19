/**
 * Draws maps during the build, on all cores, with the page's engine. Pictures are cached, since the same link and
 * engine make the same picture.
 */

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";
import type { Shot } from "./shots.ts";

const DRAWER = new URL("../../scripts/draw-maps.mjs", import.meta.url);
const KEPT = fileURLToPath(new URL("../../node_modules/.cache/riverseed-maps", import.meta.url));
/** The files on which pictures depend besides their links. */
const MAKERS = [
  "../../pkg-steer/riverseed_steer_bg.wasm",
  "../../pkg-tell/riverseed_tell_bg.wasm",
  "../../scripts/draw-maps.mjs",
];

/** Pictures of one map. */
export interface Order {
  readonly link: string;
  readonly shots: readonly Shot[];
}

type Answer = { files: Uint8Array[] } | { error: string };

/** Returns the files of all orders, in the same order. */
export async function drawAll(orders: readonly Order[]): Promise<Uint8Array[][]> {
  const makers = hashOfMakers();
  const files = orders.map((order) => keptFor(order, makers));
  const missing = orders.map((_, i) => i).filter((i) => files[i] === undefined);
  const threads = Math.min(availableParallelism(), missing.length);
  await Promise.all(Array.from({ length: threads }, () => drawMissing(missing, orders, makers, files)));
  return files.map((made) => made ?? []);
}

/** Draws missing orders in a thread until none is left. */
async function drawMissing(
  missing: number[],
  orders: readonly Order[],
  makers: string,
  files: (Uint8Array[] | undefined)[],
): Promise<void> {
  const worker = new Worker(DRAWER);
  try {
    for (let i = missing.shift(); i !== undefined; i = missing.shift()) {
      const order = orders[i];
      if (!order) continue;
      const made = await drawn(worker, order);
      keep(order, makers, made);
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

function keptFor(order: Order, makers: string): Uint8Array[] | undefined {
  try {
    return order.shots.map((shot) => readFileSync(placeOf(order.link, shot, makers)));
  } catch {
    return undefined;
  }
}

/** Caches files. Each is renamed into place, so that another build at the same time finds it complete or not at all. */
function keep(order: Order, makers: string, files: readonly Uint8Array[]): void {
  mkdirSync(KEPT, { recursive: true });
  for (const [i, shot] of order.shots.entries()) {
    const place = placeOf(order.link, shot, makers);
    const unfinished = `${place}.${process.pid}`;
    writeFileSync(unfinished, files[i] ?? new Uint8Array());
    renameSync(unfinished, place);
  }
}

function placeOf(link: string, shot: Shot, makers: string): string {
  return join(KEPT, `${hashOf([makers, link, JSON.stringify(shot)])}.${shot.format}`);
}

function hashOfMakers(): string {
  return hashOf(MAKERS.map((file) => readFileSync(new URL(file, import.meta.url))));
}

function hashOf(parts: readonly (string | Uint8Array)[]): string {
  const hash = createHash("sha256");
  for (const part of parts) hash.update(part).update("\0");
  return hash.digest("hex").slice(0, 32);
}
