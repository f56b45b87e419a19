/** Hands a picture, a line of text and a link to the system's share sheet, where there is one. */

/** The picture, the line and the link that are sent together. */
export interface Message {
  file: File;
  text: string;
  url: string;
}

/**
 * The outcome: it was taken; the visitor closed the sheet; the press was too long ago for the browser; or there is
 * no sheet that takes it.
 */
export type Outcome = "sent" | "cancelled" | "late" | "refused";

/** The part of `navigator` that shares. */
export type Sharer = Partial<Pick<Navigator, "share" | "canShare">>;

/** Returns whether the system's share sheet takes pictures. */
export function takesPictures(sharer: Sharer, file = new File([""], "picture.png", { type: "image/png" })): boolean {
  try {
    return sharer.share !== undefined && (sharer.canShare?.({ files: [file] }) ?? false);
  } catch {
    return false;
  }
}

/** Opens the share sheet, which only a press of a moment ago may do. */
export async function send({ file, text, url }: Message, sharer: Sharer): Promise<Outcome> {
  if (!sharer.share || !takesPictures(sharer, file)) return "refused";
  try {
    await sharer.share({ files: [file], text, url });
    return "sent";
  } catch (thrown) {
    const name = thrown instanceof DOMException ? thrown.name : "";
    if (name === "AbortError") return "cancelled";
    return name === "NotAllowedError" ? "late" : "refused";
  }
}
