/** Adds the gallery to the site: during the build, or in the dev server when a file is requested. */

import type { Plugin } from "vite";
import { madeOnRequest, type Source } from "../made-on-request.ts";
import { drawAll } from "./drawing.ts";
import { filesOf, oembedOf, overviewPage, type Place, pageOf, shapesSheet } from "./pages.ts";
import { type Entry, entries } from "./recipes.ts";
import { cardShot, overviewShot, pageShot } from "./shots.ts";

const FOLDER = "gallery";
/** The pages' style sheet, which is an input of the build. */
export const SHEET = "src/style/gallery.css";

export function gallery(site: string | undefined): Plugin {
  return {
    name: "gallery",
    configureServer: madeOnRequest(FOLDER, TYPES, (file) =>
      made(file, { site, sheet: `../${SHEET}`, hasPolicy: false }),
    ),
    async generateBundle(_options, bundle) {
      const sheet = Object.values(bundle).find(
        ({ type, fileName }) => type === "asset" && /gallery-[\w-]+\.css$/.test(fileName),
      );
      if (!sheet) throw new Error("the build has no style sheet for the gallery");
      const emit = (file: string, source: Source) =>
        this.emitFile({ type: "asset", fileName: `${FOLDER}/${file}`, source });
      const all = entries();
      for (const [file, source] of writtenFor(all, { site, sheet: `../${sheet.fileName}`, hasPolicy: true }))
        emit(file, source);
      for (const [file, source] of await drawnFor(all)) emit(file, source);
    },
  };
}

const TYPES: Readonly<Record<string, string>> = { css: "text/css", webp: "image/webp", jpg: "image/jpeg" };

/** Makes a file of the gallery, if there is one of this name. Only its own map is drawn. */
async function made(file: string, place: Place): Promise<Source | undefined> {
  const all = entries();
  const written = writtenFor(all, place).get(file);
  if (written !== undefined) return written;
  const entry = all.find(({ slug }) => Object.values(filesOf(slug)).includes(file));
  return entry && (await drawnFor([entry])).get(file);
}

function writtenFor(all: readonly Entry[], place: Place): Map<string, string> {
  const files = new Map([
    ["index.html", overviewPage(all, place)],
    ["shapes.css", shapesSheet(all)],
  ]);
  for (const [i, entry] of all.entries()) {
    const before = all.at(i - 1) ?? entry;
    const after = all[(i + 1) % all.length] ?? entry;
    files.set(filesOf(entry.slug).page, pageOf(entry, { before, after }, place));
    if (place.site !== undefined) files.set(filesOf(entry.slug).oembed, oembedOf(entry, place.site));
  }
  return files;
}

async function drawnFor(all: readonly Entry[]): Promise<Map<string, Uint8Array>> {
  const orders = all.map(({ link, title, aspect, land }) => {
    const shape = Number(aspect);
    return { link, shots: [overviewShot(shape), pageShot(shape), cardShot(shape, title, land)] };
  });
  const files = await drawAll(orders);
  return new Map(
    all.flatMap(({ slug }, i) => {
      const { overview, picture, card } = filesOf(slug);
      return [overview, picture, card].map((name, k) => [name, files[i]?.[k] ?? new Uint8Array()] as const);
    }),
  );
}
