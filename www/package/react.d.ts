/** `<river-seed>` in React's JSX: `import type {} from "riverseed/react"` once, anywhere in your program. */

import type { ClassAttributes, HTMLAttributes } from "react";
import type { RiverSeedListeners, RiverSeedMarkup } from "./jsx.js";
import type { RiverSeed } from "./src/apps/widget/element.js";

type Theirs = Omit<HTMLAttributes<RiverSeed>, keyof RiverSeedMarkup | keyof RiverSeedListeners>;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "river-seed": Theirs & ClassAttributes<RiverSeed> & RiverSeedMarkup & RiverSeedListeners;
    }
  }
}
