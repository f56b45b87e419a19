/** Saves files. */

import { el } from "../../../browser/dom.ts";

export function save(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  // Once the download has begun it keeps the blob alive, and after this time it has begun in every browser.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
