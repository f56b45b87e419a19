/** A screenshot, as base64 of a PNG, in numbers: its size, and the digest of its RGBA bytes. Runs in any browser's page. */
export async function pixels(png: string): Promise<{ width: number; height: number; sha256: string }> {
  const bytes = Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d");
  if (!context) throw new Error("no context");
  context.drawImage(bitmap, 0, 0);
  const digest = await crypto.subtle.digest("SHA-256", context.getImageData(0, 0, width, height).data);
  const sha256 = Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
  return { width, height, sha256 };
}
