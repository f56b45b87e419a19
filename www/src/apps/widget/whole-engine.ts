/** Stands in for `engines.ts` in the classic script, which can load no other file: it has the whole engine in it. */

import type { River } from "../../engine/types.ts";
import { loadWhole, type WholeCore } from "../../engine/whole.ts";
import type { RiverMaker } from "../../player/river-player.ts";

export class Engines {
  private constructor(private readonly core: WholeCore) {}

  /** Starts the engine. */
  static async open(): Promise<Engines> {
    return new Engines(await loadWhole());
  }

  makerFor(): RiverMaker<River> {
    return this.core;
  }

  async whole(): Promise<WholeCore> {
    return this.core;
  }
}
