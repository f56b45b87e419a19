/**
 * The poster: a picture of the country of the day, in the map's place until that is painted. It is built for one day of the
 * year, and on all others there is none: no country is shown for another. Visitors without scripts see it every day. There are
 * posters for light and dark pages and for both shapes of window, as in `firstLink` of src/apps/page/preferences.ts.
 */

import type { Plugin } from "vite";
import { wordOf } from "../src/apps/page/day/day.ts";
import { withEarlyScript } from "./early.ts";
import { drawAll } from "./gallery/drawing.ts";
import type { Shot } from "./gallery/shots.ts";

/**
 * The poster's width and height in those of the map, as in src/style/poster.css: at its edge the sea has become even.
 */
const SURROUNDINGS = 1.5;

/** The margin around the map that nothing covers on the page, in widths of the map. */
const MARGIN = 0.02;

/** A poster for windows that match a media query. The last is for all others. */
interface Poster {
  readonly file: string;
  readonly media: string;
  readonly link: string;
  readonly aspect: number;
  /** Pixels across the map. */
  readonly across: number;
  /** The map's width in CSS pixels on most screens: letters and the scale bar have its sizes, so that they are the map's. */
  readonly shown: number;
}

/** The day with a poster, as a script of a page calls its month and its day. */
export const POSTER_DAY = [0, 1] as const;

const COUNTRY = `seed=${encodeURIComponent(wordOf(new Date(2024, ...POSTER_DAY)))}`;

const UPRIGHT = { aspect: 0.75, across: 520, shown: 347 };
const WIDE = { aspect: 1.6, across: 900, shown: 1200 };
const DARK = "(prefers-color-scheme: dark)";
const PORTRAIT = "(orientation: portrait)";

export const POSTERS: readonly Poster[] = [
  {
    file: "night-upright.webp",
    media: `${DARK} and ${PORTRAIT}`,
    link: `${COUNTRY}&style=night&aspect=0.75`,
    ...UPRIGHT,
  },
  { file: "upright.webp", media: PORTRAIT, link: `${COUNTRY}&aspect=0.75`, ...UPRIGHT },
  { file: "night.webp", media: DARK, link: `${COUNTRY}&style=night`, ...WIDE },
  { file: "day.webp", media: "all", link: COUNTRY, ...WIDE },
];

const FOLDER = "poster";
const PLACE = '<canvas id="canvas"';

export function poster(page: string): Plugin {
  return {
    name: "poster",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(html, { path }) {
        if (path.slice(1) !== page) return html;
        if (!html.includes(PLACE)) throw new Error(`${page} has no place for the poster`);
        return withEarlyScript(html.replace(PLACE, `${picture()}\n          ${PLACE}`), asksEarly());
      },
    },
    async generateBundle() {
      const files = await drawAll(POSTERS.map((one) => ({ link: one.link, shots: [shotOf(one)] })));
      for (const [i, { file }] of POSTERS.entries())
        this.emitFile({ type: "asset", fileName: `${FOLDER}/${file}`, source: files[i]?.[0] ?? new Uint8Array() });
    },
  };
}

/**
 * Writes the script that requests the poster early, on a page without a link, on its day. A page without a poster does not
 * fetch it, since its loading is lazy.
 */
function asksEarly(): string {
  const posters = POSTERS.map(({ file, media }) => [`./${FOLDER}/${file}`, media]);
  const [month, day] = POSTER_DAY;
  return `{
  const now = new Date();
  const isLinked = location.search.length > 1 || location.hash.includes("=");
  if (isLinked || now.getMonth() !== ${month} || now.getDate() !== ${day}) document.documentElement.dataset.withoutPoster = "";
  else {
    const [href] = ${JSON.stringify(posters)}.find(([, media]) => matchMedia(media).matches);
    const link = Object.assign(document.createElement("link"), { rel: "preload", as: "image", fetchPriority: "high", href });
    document.head.append(link);
  }
}`;
}

function picture(): string {
  const sources = POSTERS.slice(0, -1).map(
    (one) => `<source media="${one.media}" srcset="./${FOLDER}/${one.file}"${sizeOf(one)} />`,
  );
  const [other] = POSTERS.slice(-1);
  const img =
    other && `<img src="./${FOLDER}/${other.file}"${sizeOf(other)} alt="" loading="lazy" fetchpriority="high" />`;
  return `<picture class="poster">${sources.join("")}${img}</picture>`;
}

function sizeOf(one: Poster): string {
  const { width, height } = shotOf(one);
  return ` width="${width}" height="${height}"`;
}

function shotOf({ aspect, across, shown }: Poster): Shot {
  const around = (SURROUNDINGS - 1) / 2;
  // On the page other things cover all but the map and a margin: what stands in corners keeps to that.
  const covered = around - MARGIN;
  return {
    width: Math.round(across * SURROUNDINGS),
    height: Math.round((across / aspect) * SURROUNDINGS),
    ratio: across / shown,
    framing: [
      -around,
      -around / aspect,
      SURROUNDINGS,
      covered,
      around / aspect - MARGIN,
      covered,
      around / aspect - MARGIN,
    ],
    format: "webp",
    quality: 48,
  };
}
