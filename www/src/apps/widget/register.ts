/** Registers the element, once even if a page includes it twice. */

import { RiverSeed } from "./element.ts";

export function register(): void {
  if ("customElements" in globalThis && !customElements.get("river-seed"))
    customElements.define("river-seed", RiverSeed);
}
