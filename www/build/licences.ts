/** Licences in the site: those of others ask everybody who distributes their work to distribute the licence with it. */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];
/** The npm packages whose code is in the site: what writes archives of game packs, and videos, and what keeps the page. */
const PACKAGES = [
  "fflate",
  "mediabunny",
  "workbox-core",
  "workbox-precaching",
  "workbox-routing",
  "workbox-strategies",
];

/** What the Mozilla Public License asks to be said besides. */
const SOURCES: Readonly<Record<string, string>> = {
  mediabunny:
    "Mediabunny is used as it is. Its source is at https://github.com/Vanilagy/mediabunny, and in the npm package mediabunny.\n\n",
};

export function licences(): Plugin {
  return {
    name: "licences",
    generateBundle() {
      for (const fileName of LICENCES) {
        const source = readFileSync(new URL(`../../${fileName}`, import.meta.url));
        this.emitFile({ type: "asset", fileName, source });
      }
      for (const name of PACKAGES) {
        const source = readFileSync(new URL(`../node_modules/${name}/LICENSE`, import.meta.url));
        const said = SOURCES[name] ?? "";
        this.emitFile({ type: "asset", fileName: `LICENSE-${name}.txt`, source: said + source });
      }
    },
  };
}
