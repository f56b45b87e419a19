/** Taking the picture along: as a file, as a link. */

import type { River } from "../pkg/riverseed.js";
import { Blitter } from "./blit.ts";
import type { Size } from "./canvas.ts";
import { el } from "./dom.ts";
import type { Core } from "./wasm.ts";

/** Pixels on the long side of the file: a full page in print, and on any screen more than there is. */
const LONG_SIDE_PX = 3000;
/** What growing for a file may take at a time, so that the page goes on answering. */
const SLICE_MS = 12;

/** The finished river of a link as a PNG, drawn for the file rather than enlarged from the screen. */
export async function picture(core: Core, link: string): Promise<Blob> {
  const river = new core.engine.River(link, 16, 16);
  try {
    const { width, height } = sizeFor(river.aspect);
    river.resize(width, height);
    while (!advanceFor(river, SLICE_MS)) await new Promise((resume) => setTimeout(resume));
    const canvas = el("canvas", { width, height });
    const context = canvas.getContext("2d", { alpha: false });
    if (!context) throw new Error("this browser gives no 2D canvas");
    river.paint();
    new Blitter(context, core.memory).blit(river);
    return await toPng(canvas);
  } finally {
    river.free();
  }
}

function sizeFor(aspect: number): Size {
  const shrink = LONG_SIDE_PX / Math.max(aspect, 1);
  return { width: Math.round(aspect * shrink), height: Math.round(shrink) };
}

function advanceFor(river: River, milliseconds: number): boolean {
  const end = performance.now() + milliseconds;
  do {
    if (river.advance(1)) return true;
  } while (performance.now() < end);
  return false;
}

function toPng(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

/** A file name from a seed: letters and digits of any script, the rest as hyphens. */
export function fileName(seed: string): string {
  const word = seed.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
  return word === "" ? "riverseed.png" : `riverseed-${word}.png`;
}

export function save(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  // The download has its own hold on the blob once it began; one task later is soon enough in every browser.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Copies text. False where the browser does not let the page: without https, or when the person says no. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
