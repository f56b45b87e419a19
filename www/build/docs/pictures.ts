/** The maps that the first pages show: those of the gallery, and those that are drawn for a page alone. */

import type { Size } from "../../src/browser/canvas.ts";
import { drawAll } from "../gallery/drawing.ts";
import { filesOf } from "../gallery/pages.ts";
import { entries } from "../gallery/recipes.ts";
import { overviewShot, pageShot } from "../gallery/shots.ts";
import { type OwnMap, READERS, type Reader } from "./readers.ts";

interface Image extends Size {
  /** Its address in the site. */
  readonly address: string;
}

/** The pictures of a map: one for the card of a reader, one for the reader's page. */
export interface Picture {
  readonly link: string;
  readonly sentence: string;
  readonly card: Image;
  readonly page: Image;
}

/** The pictures by the names of their readers. */
export type Pictures = ReadonlyMap<string, Picture>;

export function pictures(): Pictures {
  const gallery = new Map(entries().map((entry) => [entry.slug, entry]));
  return new Map(
    READERS.flatMap((reader) => {
      const { name, map } = reader;
      if (map === undefined) return [];
      const { link, sentence, aspect } = typeof map === "string" ? found(gallery.get(map), map) : map;
      const { overview, picture } = typeof map === "string" ? galleryFiles(map) : ownFiles(reader);
      const card = { address: overview, ...sizeOf(overviewShot(Number(aspect))) };
      return [
        [name, { link, sentence, card, page: { address: picture, ...sizeOf(pageShot(Number(aspect))) } }] as const,
      ];
    }),
  );
}

/** Draws the pictures that the gallery does not have, by their addresses in the site. */
export async function drawn(): Promise<Map<string, Uint8Array>> {
  const own = READERS.flatMap((reader) => (isOwn(reader.map) ? { map: reader.map, files: ownFiles(reader) } : []));
  const files = await drawAll(
    own.map(({ map: { link, aspect } }) => ({
      link,
      shots: [overviewShot(Number(aspect)), pageShot(Number(aspect))],
    })),
  );
  return new Map(
    own.flatMap(({ files: { overview, picture } }, i) =>
      [overview, picture].map((address, k) => [address, files[i]?.[k] ?? new Uint8Array()] as const),
    ),
  );
}

function isOwn(map: Reader["map"]): map is OwnMap {
  return typeof map === "object";
}

function galleryFiles(slug: string): { overview: string; picture: string } {
  const { overview, picture } = filesOf(slug);
  return { overview: `gallery/${overview}`, picture: `gallery/${picture}` };
}

function ownFiles({ name }: Reader): { overview: string; picture: string } {
  return { overview: `docs/for/${name}-overview.webp`, picture: `docs/for/${name}.webp` };
}

function sizeOf({ width, height }: Size): Size {
  return { width, height };
}

function found<Found>(one: Found | undefined, name: string): Found {
  if (one === undefined) throw new Error(`the gallery has no map ${name}`);
  return one;
}
