/**
 * Draws the small pictures on the buttons of the countries: during the build, or in the dev server when one is
 * requested.
 */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";
import { initSync, readLink } from "../pkg-steer/riverseed_steer.js";
import { Camera } from "../src/apps/page/map/camera.ts";
import { drawAll, type Order } from "./gallery/drawing.ts";
import type { Shot } from "./gallery/shots.ts";
import { table } from "./table.ts";

/** The size, twice as large as shown, for dense screens. `.preset img` in src/style/panel.css has the same shape. */
const SIZE = { width: 216, height: 136 };
/** The margin around the map in a picture. */
const MARGIN_PX = 6;
/** The folder from which the page requests the pictures: `COUNTRY_PICTURES` in src/apps/page/panel/choices.ts. */
const FOLDER = "countries";

interface Picture extends Order {
  readonly file: string;
}

export function countries(): Plugin {
  return {
    name: "countries",
    configureServer: ({ middlewares }) => {
      middlewares.use((request, response, next) => {
        const [path] = (request.url ?? "").split("?");
        const picture = pictures().find(({ file }) => path?.endsWith(`/${file}`));
        if (!picture) return next();
        drawAll([picture]).then(([files]) => {
          response.setHeader("Content-Type", "image/webp");
          response.end(files?.[0]);
        }, next);
      });
    },
    async generateBundle() {
      const all = pictures();
      const files = await drawAll(all);
      for (const [i, { file }] of all.entries())
        this.emitFile({ type: "asset", fileName: file, source: files[i]?.[0] ?? new Uint8Array() });
    },
  };
}

function pictures(): Picture[] {
  initSync({ module: readFileSync(new URL("../pkg-steer/riverseed_steer_bg.wasm", import.meta.url)) });
  return table.countries.map(({ name, values }) => {
    const { link } = readLink(`${new URLSearchParams(values.map(([key, value]) => [key, value]))}&style=atlas`);
    return { file: `${FOLDER}/${name}.webp`, link, shots: [shotOf(Number(new Map(values).get("aspect")))] };
  });
}

/** Returns a shot of the whole map, whatever its shape. */
function shotOf(aspect: number): Shot {
  const insets = { left: MARGIN_PX, top: MARGIN_PX, right: MARGIN_PX, bottom: MARGIN_PX };
  return { ...SIZE, format: "webp", quality: 62, framing: new Camera().framingOn({ ...SIZE, insets, aspect }) };
}
