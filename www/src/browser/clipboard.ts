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
