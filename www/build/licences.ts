/** Licences in the site: those of others ask everybody who distributes their work to distribute the licence with it. */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];
/** The npm packages whose code is in the site: what the archives of game packs are written by, and what keeps the page. */
const PACKAGES = [
  "fast-png",
  "fflate",
  "iobuffer",
  "workbox-core",
  "workbox-precaching",
  "workbox-routing",
  "workbox-strategies",
];

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
        this.emitFile({ type: "asset", fileName: `LICENSE-${name}.txt`, source });
      }
    },
  };
}
