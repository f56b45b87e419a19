/**
 * Lays labels and scenery over finished maps, and asks the teller about maps. The teller is fetched, once, when it is
 * first wanted.
 */

import type { Framing } from "../browser/canvas.ts";
import { missing, named, type PageError } from "../engine/errors.ts";
import type { Teller } from "../engine/tell.ts";
import type { FinishedMap, River } from "../engine/types.ts";
import { isEngineUnsure } from "../engine/unsure.ts";

export type LoadTeller = () => Promise<Teller>;

/** The part of a river that its map is handed over by, and labels are laid over. */
export type FinishedRiver = Pick<River, "link" | "wantsAnnotation" | "mapData" | "takeAnnotation" | "width" | "height">;

export interface AnnotatorEvents {
  /** Called when the teller has arrived: pictures can be painted with labels now. */
  arrived(): void;
  failed(error: PageError): void;
}

export class Annotator {
  #teller: Teller | undefined;
  /** The link of the map for which the teller was asked for last. */
  #askedFor: string | undefined;
  #isAsking = false;

  constructor(
    private readonly load: LoadTeller,
    private readonly events: AnnotatorEvents,
  ) {}

  /**
   * Lays labels and scenery over a picture that wants them, if the teller has arrived; `ratio` is device pixels per CSS
   * pixel. Returns whether it did: then the picture is to be painted again.
   */
  lay(river: FinishedRiver, ratio: number, framing?: Framing): boolean {
    if (!river.wantsAnnotation()) return false;
    if (this.#teller) return this.#lay(river, this.#teller, ratio, framing);
    void this.#ask(river.link);
    return false;
  }

  #lay(river: FinishedRiver, teller: Teller, ratio: number, framing: Framing | undefined): boolean {
    try {
      annotate(river, teller, ratio, framing);
    } catch (error) {
      // None, so that it is not tried again and again.
      river.takeAnnotation(new Uint8Array());
      this.events.failed(unlabelled(error));
    }
    return true;
  }

  /** Fetches the teller. After a failure the map is shown without labels, and it is tried again for another one. */
  async #ask(link: string): Promise<void> {
    if (this.#isAsking || this.#askedFor === link) return;
    this.#askedFor = link;
    this.#isAsking = true;
    try {
      this.#teller = await this.load();
      this.events.arrived();
    } catch (error) {
      this.events.failed(unlabelled(error));
    } finally {
      this.#isAsking = false;
    }
  }
}

/** Hands the map of a finished river to the teller and asks it something. */
export function askMap<Said>(
  river: Pick<River, "mapData">,
  { FinishedMap }: Teller,
  ask: (map: FinishedMap) => Said,
): Said {
  const map = new FinishedMap(river.mapData());
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

/** The means of making a file, besides its river. */
export interface FileMeans {
  readonly loadTeller: LoadTeller;
  /** Called before a long step: a file is painted or written in one. */
  holdOn(): void;
}

/**
 * Asks for a file's data, fetching the teller if need be. Calls `holdOn` first; it covers the work that follows at
 * once, too.
 */
export async function askMapForFile<Said>(
  river: Pick<River, "mapData">,
  { loadTeller, holdOn }: FileMeans,
  ask: (map: FinishedMap) => Said,
): Promise<Said> {
  const teller = await required(loadTeller);
  holdOn();
  return askMap(river, teller, ask);
}

/** Loads the teller for a file or an answer, which cannot be made without. */
export async function required(load: LoadTeller): Promise<Teller> {
  try {
    return await load();
  } catch (error) {
    throw missing("no-files", "the part of Riverseed that does this", error);
  }
}

/** Lays labels and scenery over the picture of a finished map. */
export function annotate(river: FinishedRiver, teller: Teller, ratio = 1, framing?: Framing): void {
  const shown = new Float32Array(framing ?? []);
  river.takeAnnotation(askMap(river, teller, (map) => map.masks(river.width, river.height, ratio, shown)));
}

function unlabelled(error: unknown): PageError {
  return missing("no-labels", "The part of Riverseed that names rivers", error, "The map is shown without names.");
}
