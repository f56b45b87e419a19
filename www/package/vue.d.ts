/** `<river-seed>` in Vue's templates: `import type {} from "riverseed/vue"` once, anywhere in your program. */

import type { DefineComponent, HTMLAttributes } from "vue";
import type { RiverSeedEventMap, RiverSeedMarkup } from "./jsx.js";

type Listeners = {
  [Name in keyof RiverSeedEventMap as `on${Capitalize<Name>}`]?: (event: RiverSeedEventMap[Name]) => void;
};

declare module "vue" {
  interface GlobalComponents {
    "river-seed": DefineComponent<
      Omit<HTMLAttributes, keyof RiverSeedMarkup | keyof Listeners> & RiverSeedMarkup & Listeners
    >;
  }
}
