/**
 * Grows every recipe of tests/digest.txt in this browser and compares the digests with the committed ones: the same
 * recipe must give the same river, bit for bit, everywhere. Tests read the result from the body's data attributes.
 */

import expected from "../../../../tests/digest.txt?raw";
import { find } from "../../browser/dom.ts";
import { named } from "../../engine/errors.ts";
import { loadFull } from "../../engine/full.ts";
import { type Line, linesOf } from "./lines.ts";

async function compare(): Promise<void> {
  const { engine } = await loadFull();
  const lines = linesOf(expected);
  const grown: Line[] = [];
  for (const { link } of lines) {
    grown.push({ link, digest: engine.digest(link) });
    await new Promise((resume) => setTimeout(resume));
  }
  const wrong = lines.filter(({ digest }, i) => grown[i]?.digest !== digest);
  document.body.dataset["digests"] = JSON.stringify(grown);
  say(
    wrong.length === 0 ? `All ${lines.length} rivers are exact.` : `${wrong.length} of ${lines.length} rivers differ.`,
  );
  document.body.dataset["wrong"] = String(wrong.length);
}

function say(text: string): void {
  find("#verdict", HTMLElement).textContent = text;
}

compare().catch((thrown: unknown) => {
  const error = named(thrown);
  say(`${error.code}: ${error.message}`);
  document.body.dataset["failed"] = error.code;
});
