// The integration for Astro: puts the element's files and the pictures into the site. `RiverSeed.astro` draws the pictures.

import { cp, readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { copyElement, refuseNested } from "./river-seed.mjs";

export default function riverSeed() {
  let folder;
  return {
    name: "river-seed",
    hooks: {
      "astro:config:setup": async ({ config, updateConfig }) => {
        folder = fileURLToPath(new URL("riverseed/", config.publicDir));
        updateConfig({ vite: { define: { RIVER_SEED_FOLDER: JSON.stringify(folder) } } });
        await copyElement(folder);
      },
      // Astro copies `public` before it renders pages, and so before the pictures are drawn.
      "astro:build:done": async ({ dir, assets }) => {
        await cp(folder, new URL("riverseed/", dir), { recursive: true });
        for (const page of [...assets.values()].flat().filter(({ pathname }) => pathname.endsWith(".html")))
          refuseNested(await readFile(page, "utf8"), page.pathname);
      },
    },
  };
}
