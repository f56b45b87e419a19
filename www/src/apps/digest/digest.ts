/**
 * Grows every recipe of tests/digest.txt and tests/digest-annotated.txt in this browser and compares the digests with
 * the committed ones: the same recipe must give the same river, bit for bit, everywhere. Tests read the result from the
 * body's data attributes.
 */

import plain from "../../../../tests/digest.txt?raw";
import annotated from "../../../../tests/digest-annotated.txt?raw";
import { find } from "../../browser/dom.ts";
import { named, PageError } from "../../engine/errors.ts";
import { loadSteer, type SteerCore } from "../../engine/steer.ts";
import { loadTeller, type Teller } from "../../engine/tell.ts";
import { loadWriter, type Writer } from "../../engine/write.ts";
import { annotate } from "../../player/annotator.ts";
import { writeMap } from "../../player/asking.ts";
import { type Line, linesOf } from "./lines.ts";

async function compare(): Promise<void> {
  const [core, teller, writer] = [await loadSteer(), await loadTeller(), await loadWriter()];
  const lines = [...linesOf(plain), ...linesOf(annotated)];
  const grown: Line[] = [];
  for (const { link } of lines) {
    grown.push({ link, digest: digestOf(core, teller, writer, link) });
    await new Promise((resume) => setTimeout(resume));
  }
  const wrong = lines.filter(({ digest }, i) => grown[i]?.digest !== digest);
  document.body.dataset["digests"] = JSON.stringify(grown);
  say(
    wrong.length === 0 ? `All ${lines.length} rivers are exact.` : `${wrong.length} of ${lines.length} rivers differ.`,
  );
  document.body.dataset["wrong"] = String(wrong.length);
}

/** Grows and paints a recipe, and returns the digest of the map and its picture. */
function digestOf({ engine, memory }: SteerCore, teller: Teller, writer: Writer, link: string): string {
  const river = new engine.River(link);
  try {
    if (river.notices.length > 0) throw new PageError("bad-params", link);
    while (river.advance(1000));
    const width = writer.digestWidth();
    river.resize(width, width);
    if (river.wantsAnnotation()) annotate(river, teller);
    while (river.paint());
    const pixels = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
    return writeMap(river, writer, (map) => map.digest(pixels, river.scattered()));
  } finally {
    river.free();
  }
}

function say(text: string): void {
  find("#verdict", HTMLElement).textContent = text;
}

compare().catch((thrown: unknown) => {
  const error = named(thrown);
  say(`${error.code}: ${error.message}`);
  document.body.dataset["failed"] = error.code;
});
