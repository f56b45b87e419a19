/** Registers `<river-seed>`, for use with bundlers. On a server it does nothing. */

import { register } from "./register.ts";

register();

export { RiverSeed } from "./element.ts";
