/** Lays labels and scenery over finished maps. The teller is fetched, once, when it is first wanted. */

import type { Framing } from "../browser/canvas.ts";
import { missing, type PageError } from "../engine/errors.ts";
import type { Teller } from "../engine/tell.ts";
import type { LabelFacts, River } from "../engine/types.ts";
import { askMap, type LoadTeller } from "./asking.ts";

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
  #fetching: Promise<void> | undefined;
  #labels: readonly LabelFacts[] = [];

  /** True while the teller is fetched. */
  get isAsking(): boolean {
    return this.#isAsking;
  }

  constructor(
    private readonly load: LoadTeller,
    private readonly events: AnnotatorEvents,
  ) {}

  /** Fetches the teller ahead of the picture that will want it. A failure is told when it does. */
  expect(): void {
    this.#fetch().catch(() => {});
  }

  /** The names that were laid last. */
  get labels(): readonly LabelFacts[] {
    return this.#labels;
  }

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
      this.#labels = annotate(river, teller, ratio, framing);
    } catch (error) {
      // None, so that it is not tried again and again.
      river.takeAnnotation(new Uint8Array());
      this.#labels = [];
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
      await this.#fetch().finally(() => {
        this.#isAsking = false;
      });
      this.events.arrived();
    } catch (error) {
      this.events.failed(unlabelled(error));
    }
  }

  #fetch(): Promise<void> {
    this.#fetching ??= this.load()
      .then((teller) => {
        this.#teller = teller;
      })
      .finally(() => {
        this.#fetching = undefined;
      });
    return this.#fetching;
  }
}

/** Lays labels and scenery over the picture of a finished map. Returns the names among them. */
export function annotate(river: FinishedRiver, teller: Teller, ratio = 1, framing?: Framing): LabelFacts[] {
  const shown = new Float32Array(framing ?? []);
  return askMap(river, teller, (map) => {
    river.takeAnnotation(map.masks(river.width, river.height, ratio, shown));
    return map.labels();
  });
}

function unlabelled(error: unknown): PageError {
  return missing("no-labels", "The part of Riverseed that names rivers", error, "The map is shown without names.");
}
