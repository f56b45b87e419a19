/**
 * Grows every recipe of tests/digest.txt and tests/digest-annotated.txt in this browser, or those of the address's
 * `part`, and compares the digests with the committed ones: the same recipe must give the same river, bit for bit,
 * everywhere. The smallest engine that paints a map must give it the same pixels. Tests read the result from the body's
 * data attributes.
 */

import plain from "../../../../tests/digest.txt?raw";
import annotated from "../../../../tests/digest-annotated.txt?raw";
import { find } from "../../browser/dom.ts";
import { named, PageError } from "../../engine/errors.ts";
import { loadLabel } from "../../engine/label.ts";
import { type Core, load as loadMake } from "../../engine/make.ts";
import type { River } from "../../engine/types.ts";
import { loadWhole, type WholeCore } from "../../engine/whole.ts";
import { type Line, linesOf, partOf } from "./lines.ts";

interface Engines {
  bare: Core;
  labelling: Core;
  whole: WholeCore;
}

async function compare(): Promise<void> {
  const [bare, labelling, whole] = await Promise.all([loadMake(), loadLabel(), loadWhole()]);
  const lines = partOf([...linesOf(plain), ...linesOf(annotated)], new URLSearchParams(location.search).get("part"));
  const grown: Line[] = [];
  for (const { link } of lines) {
    grown.push({ link, digest: digestOf({ bare, labelling, whole }, link) });
    await new Promise((resume) => setTimeout(resume));
  }
  const wrong = lines.filter(({ digest }, i) => grown[i]?.digest !== digest);
  document.body.dataset["digests"] = JSON.stringify(grown);
  say(
    wrong.length === 0 ? `All ${lines.length} rivers are exact.` : `${wrong.length} of ${lines.length} rivers differ.`,
  );
  document.body.dataset["wrong"] = String(wrong.length);
}

/** Returns the digest of a recipe's map and picture; other words if a smaller engine paints other pixels. */
function digestOf({ bare, labelling, whole }: Engines, link: string): string {
  const river = new whole.engine.River(link);
  const width = whole.engine.digestWidth();
  const small = river.isAnnotated ? labelling : bare;
  const other = new small.engine.River(link);
  try {
    if (river.notices.length > 0) throw new PageError("bad-params", link);
    const [pixels, others] = [painted(river, whole, width), painted(other, small, width)];
    return pixels.every((byte, i) => byte === others[i]) ? river.digest() : "other pixels in the smaller engine";
  } finally {
    river.free();
    other.free();
  }
}

/** Grows and paints a river. Returns its pixels, which stay where they are until something else is done with its engine. */
function painted(river: River, { memory }: Pick<Core, "memory">, width: number): Uint8Array {
  while (river.advance(1000));
  river.resize(width, width);
  while (river.paint());
  return new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
}

function say(text: string): void {
  find("#verdict", HTMLElement).textContent = text;
}

compare().catch((thrown: unknown) => {
  const error = named(thrown);
  say(`${error.code}: ${error.message}`);
  document.body.dataset["failed"] = error.code;
});
