/** The widgets' part of the messages with their renderer. */

import type { Report as AnyReport, Reading, Status } from "../../host/protocol.ts";
import type { LinkToRead } from "../../player/river-player.ts";

/**
 * Returns the link that a widget asks for. `text` and `letters` are the author's and may be anything; `dark` is true on a
 * dark page. `values` are link text that takes precedence; with them, `text` need not be a link.
 */
export function linkToRead(text: string, dark: boolean, letters = "", values?: string) {
  const options = { widget: true, dark, ...(values !== undefined && { values }) };
  return { text, options, letters } satisfies LinkToRead;
}

/** A request for a file of a river. */
export interface FileRequest {
  format: "png" | "svg";
  /** Pixels on the long side of a PNG. */
  longSide: number;
}

/** The only question: for a file of finished rivers, which need not be shown anywhere. */
export interface Question extends FileRequest {
  link: LinkToRead;
}

export type Report = AnyReport<Blob>;

/** The river on the canvas, as it has told of itself. */
export type Seen = Status & { reading: Reading };

/** The first message to a worker: what the first element asks for. */
export interface Init {
  /** The address of the smallest engine, if the engines are not beside the script. */
  wasmUrl: string | undefined;
  /** The map, which decides which engine is loaded first. */
  link: LinkToRead;
}
