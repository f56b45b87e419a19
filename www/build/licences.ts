/** Licences in the site: those of others ask everybody who distributes their work to distribute the licence with it. */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];

export function licences(): Plugin {
  return {
    name: "licences",
    generateBundle() {
      for (const fileName of LICENCES) {
        const source = readFileSync(new URL(`../../${fileName}`, import.meta.url));
        this.emitFile({ type: "asset", fileName, source });
      }
    },
  };
}
