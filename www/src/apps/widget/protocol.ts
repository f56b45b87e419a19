/** What widgets and their renderer say to each other besides what everybody does who shows a river. */

import type { Report as AnyReport } from "../../host/protocol.ts";
import type { LinkToRead } from "../../player/river-player.ts";

/** What a widget asks for: link text as its author gave it, anything, and whether it stands on a dark page. */
export function linkToRead(text: string, dark: boolean) {
  return { text, options: { widget: true, dark } } satisfies LinkToRead;
}

/** What is made of a river besides a picture on the page. */
export interface FileRequest {
  format: "png" | "svg";
  /** Pixels on the long side of a PNG. */
  longSide: number;
}

/** The only question: a file of finished rivers, which need not be shown anywhere. */
export interface Question extends FileRequest {
  link: LinkToRead;
  /** Where the lean engine is, if not beside the script; the full one lies beside it. */
  wasmUrl: string | undefined;
}

export type Report = AnyReport<Blob>;

/** The first message to a worker: where the engine is, if not beside the script. */
export interface Init {
  wasmUrl: string | undefined;
}
