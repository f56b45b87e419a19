/** The means of making files. */

import type { MapFiles, River } from "../engine/types.ts";
import { annotate } from "../player/annotator.ts";
import { type LoadTeller, type LoadWriter, required, writeMap } from "../player/asking.ts";

/** The means of making a file, besides its river. */
export interface FileMeans {
  readonly loadTeller: LoadTeller;
  readonly loadWriter: LoadWriter;
  /** Called before a long step: a file is painted or written in one. */
  holdOn(): void;
}

/**
 * Has the writer write a finished map, fetching the writer if need be. Calls `holdOn` first; it covers the work that
 * follows at once, too.
 */
export async function written<Written>(
  river: Pick<River, "mapData">,
  { loadWriter, holdOn }: FileMeans,
  write: (map: MapFiles) => Written,
): Promise<Written> {
  const writer = await required(loadWriter);
  holdOn();
  return writeMap(river, writer, write);
}

/** The part of the map's surroundings that a picture shows, as in `River.frame`. All in widths of the map. */
export type Frame = readonly [left: number, top: number, across: number];

/**
 * Lays labels and scenery over a finished river's picture if it wants them, fetching the teller if need be. `frame` is
 * the picture's, if it does not show just the map.
 */
export async function labelled(
  river: River,
  { loadTeller, holdOn }: Omit<FileMeans, "loadWriter">,
  frame?: Frame,
): Promise<void> {
  if (!river.wantsAnnotation()) return;
  const teller = await required(loadTeller);
  holdOn();
  annotate(river, teller, 1, frame);
}
