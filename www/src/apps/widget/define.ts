/** Registers `<river-seed>`. For bundlers; on a server it does nothing. */

import { register } from "./register.ts";

register();

export { RiverSeed } from "./element.ts";
