/** Saves files and copies text. */

import { el } from "../../../browser/dom.ts";

export function save(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  // Once the download has begun it keeps the blob alive, and after this time it has begun in every browser.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/**
 * Copies text to the clipboard. Returns false if the browser does not allow it: without https, or if the visitor
 * refuses.
 */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
