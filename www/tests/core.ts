/** The real core in Node, to say what the page should show. */

import { createHash } from "node:crypto";
import type { Framing } from "../src/browser/canvas.ts";
import { engine, memory } from "./whole.ts";

export { engine, memory };

export interface Picture {
  /** Of the RGBA bytes. */
  sha256: string;
  summary: engine.Summary;
}

/** What has been drawn: a test asks for the same picture again and again until the page shows it. */
const drawn = new Map<string, Picture>();

/** The finished river of a link, as the River class draws it at a size: what a framing shows of it, or all that covers the picture. */
export function pictureOf(link: string, width: number, height: number, framing?: Framing): Picture {
  return kept(link, width, height, { framing });
}

/** The same as an element has it, which carries letters, or none. */
export function embeddedPictureOf(link: string, width: number, height: number, letters = ""): Picture {
  return kept(link, width, height, { letters });
}

interface Drawing {
  framing?: Framing | undefined;
  letters?: string;
}

function kept(link: string, width: number, height: number, drawing: Drawing): Picture {
  const key = JSON.stringify([link, width, height, drawing]);
  const picture = drawn.get(key) ?? draw(link, width, height, drawing);
  drawn.set(key, picture);
  return picture;
}

function draw(link: string, width: number, height: number, { framing, letters }: Drawing): Picture {
  const river = new engine.River(engine.readLink(link).link);
  if (letters !== undefined) river.takeLetters(letters, width, height, 1);
  river.resize(width, height);
  if (framing) river.frame(new Float32Array(framing));
  while (river.advance(1000));
  while (river.paint());
  const bytes = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
  const sha256 = createHash("sha256").update(bytes).digest("hex");
  const summary = river.summary();
  river.free();
  return { sha256, summary };
}

/** A river's picture as it stands: RGBA. */
export function pixelsOf(river: engine.River): Uint8Array {
  while (river.paint());
  return new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
}

/** How many pixels of two pictures of one size differ, so that one sees it. */
export function differing(one: Uint8Array, other: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < one.length; i += 4) {
    const by = (channel: number): number => Math.abs((one[i + channel] ?? 0) - (other[i + channel] ?? 0));
    if (Math.max(by(0), by(1), by(2)) > 24) count++;
  }
  return count;
}

export { parameter } from "./table.ts";
