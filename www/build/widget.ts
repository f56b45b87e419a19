/**
 * Adds the element's files to the site, under the names by which other pages load them: `widget/river-seed.js` and the
 * files it needs.
 */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

const BUILT = "dist-widget";
const FOLDER = "widget";

export function widgetFiles(): Plugin {
  return {
    name: "widget-files",
    // The dev server has no built files and serves the source.
    configureServer: ({ middlewares }) => {
      middlewares.use((request, _response, next) => {
        if (request.url?.startsWith(`/${FOLDER}/river-seed.js`)) request.url = "/src/apps/widget/river-seed.ts";
        next();
      });
    },
    generateBundle() {
      for (const file of filesOf(BUILT))
        this.emitFile({ type: "asset", fileName: `${FOLDER}/${file}`, source: readFileSync(join(BUILT, file)) });
    },
  };
}

function filesOf(folder: string): string[] {
  try {
    return readdirSync(folder);
  } catch {
    throw new Error(`there is no ${folder}: build the element first (npm run build:widget)`);
  }
}
