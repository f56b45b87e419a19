/** Files of the rivers that an element asks for. */

import type { Size } from "../../browser/canvas.ts";
import { initOf, linkToReadOf } from "./attributes.ts";
import { renderHost } from "./backend.ts";
import type { FileRequest } from "./protocol.ts";

export interface BlobOptions {
  /** Pixels on the picture's long side; by default as many as are shown. */
  longSide?: number;
}

/** Asks for a PNG; `shown` is the size of the picture in the element, 0 while that is not laid out. */
export function askForPng(element: Element, shown: Size, { longSide }: BlobOptions): Promise<Blob> {
  const side = Number(longSide ?? Math.max(shown.width, shown.height));
  if (longSide === undefined && side === 0 && element.isConnected)
    throw refusal("is not laid out: say how long its longSide is");
  return fileOf(element, { format: "png", longSide: side });
}

/** Asks for an SVG, and returns its text. */
export async function askForSvg(element: Element): Promise<string> {
  return (await fileOf(element, { format: "svg", longSide: 0 })).text();
}

function fileOf(element: Element, file: FileRequest): Promise<Blob> {
  if (!element.isConnected) throw refusal("is in no document");
  return renderHost.ask({ ...file, link: linkToReadOf(element) }, initOf(element));
}

function refusal(why: string): DOMException {
  return new DOMException(`this river-seed ${why}`, "InvalidStateError");
}
