/** Taking rivers along: as a file, as a link. */

import { el } from "../../../browser/dom.ts";

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
