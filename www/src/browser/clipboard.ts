/** The clipboard: copies text and pictures. */

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

/** The class of what is copied besides text, which some browsers lack. */
const { ClipboardItem: Item } = globalThis as Partial<typeof globalThis>;

/** Returns whether the browser lets pages copy pictures. */
export function copiesPictures(): boolean {
  return Item !== undefined && navigator.clipboard?.write !== undefined;
}

/** Copies a picture to the clipboard. Returns false if the browser does not allow it. */
export async function copyPicture(picture: Blob): Promise<boolean> {
  if (!Item) return false;
  try {
    await navigator.clipboard.write([new Item({ [picture.type]: picture })]);
    return true;
  } catch {
    return false;
  }
}
