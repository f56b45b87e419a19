/** Adds the licences to the site: those of other projects must be distributed with their work. */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"];
/**
 * The npm packages whose code is in the site: for the archives of game packs, for videos, for the search of the
 * documentation, and for keeping the page offline.
 */
const PACKAGES = [
  "fflate",
  "mediabunny",
  "minisearch",
  "workbox-core",
  "workbox-precaching",
  "workbox-routing",
  "workbox-strategies",
];

/** The names of licence files that are called otherwise. */
const FILES: Readonly<Record<string, string>> = { minisearch: "LICENSE.txt" };

/** The additional text that the Mozilla Public License requires. */
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
        const source = readFileSync(new URL(`../node_modules/${name}/${FILES[name] ?? "LICENSE"}`, import.meta.url));
        const said = SOURCES[name] ?? "";
        this.emitFile({ type: "asset", fileName: `LICENSE-${name}.txt`, source: said + source });
      }
    },
  };
}
