/** Licences in the site: those of others ask that whoever hands out their work hands out their words with it. */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const PAPERS = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];

export function papers(): Plugin {
  return {
    name: "papers",
    generateBundle() {
      for (const fileName of PAPERS) {
        const source = readFileSync(new URL(`../../${fileName}`, import.meta.url));
        this.emitFile({ type: "asset", fileName, source });
      }
    },
  };
}
