/** Asks the teller about finished maps, and the writer for their files. */

import { missing, named } from "../engine/errors.ts";
import type { Teller } from "../engine/tell.ts";
import type { FinishedMap, MapFiles, River } from "../engine/types.ts";
import { isEngineUnsure } from "../engine/unsure.ts";
import type { Writer } from "../engine/write.ts";

export type LoadTeller = () => Promise<Teller>;
export type LoadWriter = () => Promise<Writer>;

/** The part of a river that its map is handed over by. */
type Mapped = Pick<River, "mapData">;

/** Hands the map of a finished river to the teller and asks it something. */
export function askMap<Said>(river: Mapped, { FinishedMap }: Teller, ask: (map: FinishedMap) => Said): Said {
  return handed(river, FinishedMap, ask);
}

/** Hands the map of a finished river to the writer and has it write something. */
export function writeMap<Written>(river: Mapped, { MapFiles }: Writer, write: (map: MapFiles) => Written): Written {
  return handed(river, MapFiles, write);
}

/** Loads a module for a file or an answer, which cannot be made without. */
export async function required<Module>(load: () => Promise<Module>): Promise<Module> {
  try {
    return await load();
  } catch (error) {
    // A part that was left out says so itself.
    if (named(error).code === "no-files") throw error;
    throw missing("no-files", "the part of Riverseed that does this", error);
  }
}

function handed<Kept extends { free(): void }, Said>(
  river: Mapped,
  Reader: new (data: Uint32Array) => Kept,
  ask: (map: Kept) => Said,
): Said {
  const map = new Reader(river.mapData());
  let mayFree = true;
  try {
    return ask(map);
  } catch (error) {
    mayFree = !isEngineUnsure(named(error));
    throw error;
  } finally {
    if (mayFree) map.free();
  }
}
