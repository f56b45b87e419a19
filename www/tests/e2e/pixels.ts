/** The bytes on a canvas, in whosever hands that is. */

import type { Locator } from "@playwright/test";

export interface Pixels {
  width: number;
  height: number;
  sha256: string;
}

/**
 * What is on a canvas. One that was handed over to a worker gives no context, so a copy is read; and its picture comes a frame or two
 * after the word of it, so it is read until nothing changes any more.
 */
export async function pixelsOf(canvas: Locator): Promise<Pixels> {
  return await canvas.evaluate(async (shown: HTMLCanvasElement) => {
    const read = (): { width: number; height: number; data: Uint8ClampedArray<ArrayBuffer> } => {
      const { width, height } = shown;
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context?.drawImage(shown, 0, 0);
      return { width, height, data: context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray() };
    };
    const isOwn = (): boolean => {
      try {
        return shown.getContext("2d", { alpha: false }) !== null;
      } catch {
        return false;
      }
    };
    const frames = async (count: number): Promise<void> => {
      for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
    };
    let last = read();
    // A page that draws itself may have stopped its clock, and with it its frames.
    while (!isOwn()) {
      await frames(4);
      const next = read();
      const before = new Uint32Array(last.data.buffer);
      const isSame = new Uint32Array(next.data.buffer).every((pixel, i) => pixel === before[i]);
      if (isSame && next.width === last.width && next.height === last.height) break;
      last = next;
    }
    // Here, since megabytes on their way out of the browser would cost more than all else.
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", last.data));
    const sha256 = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
    return { width: last.width, height: last.height, sha256 };
  });
}
