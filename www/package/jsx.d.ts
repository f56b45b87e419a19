/** `<river-seed>` in markup: what frameworks' JSX and templates are made of. For one that has no entry here, name these. */

import type { RiverSeedMarkup } from "./markup.js";
import type { RiverSeedEventMap } from "./src/apps/widget/events.js";

export type { RiverSeedEventMap, RiverSeedMarkup };

/** Listeners as attributes: `oncomplete`. */
export type RiverSeedListeners = {
  [Name in keyof RiverSeedEventMap as `on${Name}`]?: ((event: RiverSeedEventMap[Name]) => void) | undefined;
};
