/** Writes the gallery's pages as HTML without scripts: the overview, and a page for each map. */

import { elementSnippet, embedAddress, escaped, titleOf } from "../../src/apps/page/share/snippets.ts";
import { policyFor } from "../policy.ts";
import { baseOf, SOME_SITE } from "../social.ts";
import type { Entry } from "./recipes.ts";
import { CARD, overviewShot, pageShot } from "./shots.ts";
import { type Head, icon, mapPage, pageWith } from "./templates.ts";

/** The site for which the pages are made. */
export interface Place {
  /** The site's address, if it is known: cards and snippets need absolute addresses. */
  readonly site: string | undefined;
  /** The address of the style sheet, relative to the gallery's folder. */
  readonly sheet: string;
  /** True if pages have a Content-Security-Policy, which those of the dev server do not. */
  readonly hasPolicy: boolean;
}

/** The number of pictures on the first screen, which are not loaded lazily. */
const FIRST = 6;
/** The width of a frame where its place has none, in CSS pixels. */
const FRAME_WIDTH_PX = 720;

/** Returns the names of a map's files. */
export const filesOf = (slug: string) => ({
  page: `${slug}.html`,
  overview: `${slug}-overview.webp`,
  picture: `${slug}.webp`,
  card: `${slug}-card.jpg`,
  oembed: `${slug}-oembed.json`,
});

export function overviewPage(entries: readonly Entry[], place: Place): string {
  const [first] = entries;
  const description = `${entries.length} maps, each grown from a word. Open one, and change it.`;
  const card = first && { file: filesOf(first.slug).card, alt: alternativeOf(first) };
  return pageWith(
    headOf(place, { title: "Gallery · Riverseed", description, address: "", card }),
    `<header>
      <p><a href="../">Riverseed</a> <span aria-hidden="true">·</span> <a href="../docs/">Documentation</a></p>
      <h1>Gallery</h1>
      <p class="lead">${description}</p>
    </header>
    <main>
      <ul class="maps">
        ${entries.map(itemOf).join("\n        ")}
      </ul>
    </main>`,
  );
}

function itemOf(entry: Entry, i: number): string {
  const { width, height } = overviewShot(Number(entry.aspect));
  const { page, overview } = filesOf(entry.slug);
  const when = i < FIRST ? 'fetchpriority="high"' : 'loading="lazy"';
  return `<li class="${shapeOf(entry)}"><a href="${page}"><img src="${overview}" width="${width}" height="${height}" alt="${escaped(entry.sentence)}" decoding="async" ${when} /><span>${escaped(entry.title)}</span></a></li>`;
}

/** Returns the class of maps of this shape, since pages may not contain styles. */
function shapeOf({ aspect }: Entry): string {
  return `shape-${Math.round(Number(aspect) * 100)}`;
}

/** Writes the style sheet with the aspects of the maps. */
export function shapesSheet(entries: readonly Entry[]): string {
  const shapes = new Map(entries.map((entry) => [shapeOf(entry), entry.aspect]));
  return [...shapes].map(([name, aspect]) => `.${name} {\n  --aspect: ${aspect};\n}\n`).join("\n");
}

export function pageOf(entry: Entry, around: { before: Entry; after: Entry }, place: Place): string {
  const { width, height } = pageShot(Number(entry.aspect));
  const { page, picture, card, oembed } = filesOf(entry.slug);
  const alt = alternativeOf(entry);
  const onPage = `../?${entry.link}`;
  const head = headOf(place, {
    title: `${entry.title} · Riverseed gallery`,
    description: entry.sentence,
    address: page,
    card: { file: card, alt },
  });
  return mapPage({
    ...head,
    oembed: place.site === undefined ? undefined : wholeIn(place.site, oembed),
    name: entry.title,
    trail: [
      { address: "../", label: "Riverseed" },
      { address: "./", label: "Gallery" },
    ],
    shape: shapeOf(entry),
    picture: { file: picture, width, height, alt },
    maker: onPage,
    acts: [{ address: onPage, label: "Open it on the page" }],
    settings: entry.settings.map(([label, value]) => ({ label, value })),
    link: entry.link,
    snippet: snippetOf(entry, place),
    others: [
      { address: filesOf(around.before.slug).page, label: `← ${around.before.title}`, rel: "prev" },
      { address: "./", label: "All maps" },
      { address: filesOf(around.after.slug).page, label: `${around.after.title} →`, rel: "next" },
      { address: "../docs/", label: "Documentation" },
    ],
  });
}

/**
 * Writes the oEmbed response of a map's page, which names it: programs that unfold addresses by discovery then show the
 * map in a frame. It is that of `riverseed page`, but for the frame's address.
 */
export function oembedOf(entry: Entry, site: string): string {
  const { link, seed, aspect } = entry;
  const height = Math.round(FRAME_WIDTH_PX / Number(aspect));
  const frame = embedAddress({ link, seed, aspect, page: baseOf(site) });
  const html = [
    `<iframe src="${escaped(frame)}" title="${escaped(entry.title)}" width="${FRAME_WIDTH_PX}" height="${height}" loading="lazy"`,
    `sandbox="allow-scripts allow-same-origin" style="width:100%;height:auto;aspect-ratio:${escaped(aspect)};border:0"></iframe>`,
  ].join(" ");
  const response = {
    version: "1.0",
    type: "rich",
    title: entry.title,
    provider_name: "Riverseed",
    html,
    width: FRAME_WIDTH_PX,
    height,
    thumbnail_url: wholeIn(site, filesOf(entry.slug).card),
    thumbnail_width: CARD.width,
    thumbnail_height: CARD.height,
  };
  return `${JSON.stringify(response, null, 2)}\n`;
}

function alternativeOf({ title, style }: Entry): string {
  return `The map ${title}, in the style ${style}`;
}

/** Returns the snippet of the element, or of the picture if the element could not grow everything on it. */
function snippetOf(entry: Entry, { site }: Place): { lead: string; code: string; placeholder: string | undefined } {
  const base = baseOf(site ?? SOME_SITE);
  const picture = wholeIn(base, filesOf(entry.slug).picture);
  const { link, seed, aspect } = entry;
  return {
    lead: entry.suitsElement
      ? "The rivers grow where you paste this:"
      : "There are more rivers here than the element grows on other people’s pages, so this shows their picture:",
    code: entry.suitsElement
      ? elementSnippet({ link, seed, aspect, page: base }, picture)
      : pictureSnippet(entry, picture, base),
    placeholder: site === undefined ? SOME_SITE : undefined,
  };
}

function pictureSnippet({ link, seed, aspect }: Entry, picture: string, base: string): string {
  const { width, height } = pageShot(Number(aspect));
  return [
    `<a href="${escaped(`${base}?${link}`)}"><img src="${escaped(picture)}"`,
    `  alt="${escaped(titleOf(seed))}" width="${width}" height="${height}" loading="lazy" style="width:100%;height:auto"></a>`,
  ].join("\n");
}

interface Content {
  readonly title: string;
  readonly description: string;
  /** The page's address, relative to the gallery's folder. */
  readonly address: string;
  readonly card: { readonly file: string; readonly alt: string } | undefined;
}

function headOf({ site, sheet, hasPolicy }: Place, { title, description, address, card }: Content): Head {
  const whole = (file: string): string => (site === undefined ? `./${file}` : wholeIn(site, file));
  return {
    policy: hasPolicy ? policyFor("") : undefined,
    title,
    description,
    icon: icon(),
    sheets: [sheet, "shapes.css"],
    address: site === undefined ? undefined : whole(address),
    card: card && { address: whole(card.file), ...CARD, alt: card.alt },
    oembed: undefined,
  };
}

/** Returns the absolute address of a file of the gallery. */
function wholeIn(site: string, file: string): string {
  return new URL(`gallery/${file}`, baseOf(site)).href;
}
