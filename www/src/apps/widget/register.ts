/** Gives the element its name. A page that includes it twice has it once. */

import { RiverSeed } from "./element.ts";

export function register(): void {
  if ("customElements" in globalThis && !customElements.get("river-seed"))
    customElements.define("river-seed", RiverSeed);
}
