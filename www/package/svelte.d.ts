/** `<river-seed>` in Svelte's markup: `import type {} from "riverseed/svelte"` once, anywhere in your program. */

import type { HTMLAttributes } from "svelte/elements";
import type { RiverSeedListeners, RiverSeedMarkup } from "./jsx.js";
import type { RiverSeed } from "./src/apps/widget/element.js";

type Theirs = Omit<HTMLAttributes<RiverSeed>, keyof RiverSeedMarkup | keyof RiverSeedListeners>;

declare module "svelte/elements" {
  interface SvelteHTMLElements {
    "river-seed": Theirs & RiverSeedMarkup & RiverSeedListeners;
  }
}
