/**
 * Draws the small pictures on the buttons of the countries and of the styles: during the build, or in the dev server
 * when one is requested. Those of the styles show the map of a visit without a link, until there is a map on show.
 */

import { readFileSync } from "node:fs";
import type { Plugin } from "vite";
import { initSync, readLink } from "../pkg-engine/riverseed_engine.js";
import { wordOf } from "../src/apps/page/day/day.ts";
import { Camera } from "../src/apps/page/map/camera.ts";
import type { Country } from "../src/engine/table.ts";
import { inStyle } from "../src/player/thumbnails.ts";
import { drawAll, type Order } from "./gallery/drawing.ts";
import type { Shot } from "./gallery/shots.ts";
import { POSTER_DAY } from "./poster.ts";
import { table } from "./table.ts";

/** The size, twice as large as shown, for dense screens. `.preset img` in src/style/panel.css has the same shape. */
const COUNTRY_SIZE = { width: 216, height: 136 };
/** The margin around the map in a country's picture. */
const MARGIN_PX = 6;
/** The size of a style's picture, which is soon replaced: as it is shown. `.style canvas` in src/style/styles.css has the same shape. */
const STYLE_SIZE = { width: 112, height: 64 };

interface Picture extends Order {
  readonly file: string;
}

export function buttonPictures(): Plugin {
  return {
    name: "button-pictures",
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
  initSync({ module: readFileSync(new URL("../pkg-engine/riverseed_engine_bg.wasm", import.meta.url)) });
  return [...table.countries.map(ofCountry), ...styles().map(ofStyle)];
}

/** The word whose countries the pictures of their kinds show. */
const WORD = "kauri";

function ofCountry({ name }: Country): Picture {
  const { link, values } = readLink(`seed=${WORD}&country=${name}&style=atlas`);
  return { file: `countries/${name}.webp`, link, shots: [wholeMap(Number(new Map(values).get("aspect")))] };
}

/** Returns a shot of the whole map, whatever its shape. */
function wholeMap(aspect: number): Shot {
  const insets = { left: MARGIN_PX, top: MARGIN_PX, right: MARGIN_PX, bottom: MARGIN_PX };
  const framing = new Camera().framingOn({ ...COUNTRY_SIZE, insets, aspect });
  return { ...COUNTRY_SIZE, format: "webp", quality: 62, framing };
}

function styles(): readonly string[] {
  return table.parameters.find(({ key }) => key === "style")?.choices?.map(({ value }) => value) ?? [];
}

/** A style's picture is like the thumbnail that replaces it: without letters and scenery. */
function ofStyle(style: string): Picture {
  const shot: Shot = { ...STYLE_SIZE, format: "webp", quality: 60 };
  return {
    file: `styles/${style}.webp`,
    link: readLink(inStyle(`seed=${wordOf(new Date(2024, ...POSTER_DAY))}`, style)).link,
    shots: [shot],
  };
}
