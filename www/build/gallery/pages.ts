/** Writes the gallery's pages as HTML without scripts: the overview, and a page for each map. */

import { elementSnippet, escaped, titleOf } from "../../src/apps/page/share/snippets.ts";
import { policyFor } from "../policy.ts";
import { baseOf, SOME_SITE } from "../social.ts";
import type { Entry } from "./recipes.ts";
import { CARD, overviewShot, pageShot } from "./shots.ts";

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

/** The icon of pages that are written during the build. */
export const ICON =
  "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32'%3E%3Crect width='32' height='32' rx='3' fill='%23f4eee0'/%3E%3Cpath d='M16 31c0-7-3-8-3-13 0-4 4-5 4-10M13 19C10 16 8 14 8 8M14.500 24c5-4 8-5 9-13' fill='none' stroke='%231c5876' stroke-width='2.500' stroke-linecap='round'/%3E%3C/svg%3E";

/** Returns the names of a map's files. */
export const filesOf = (slug: string) => ({
  page: `${slug}.html`,
  overview: `${slug}-overview.webp`,
  picture: `${slug}.webp`,
  card: `${slug}-card.jpg`,
});

export function overviewPage(entries: readonly Entry[], place: Place): string {
  const [first] = entries;
  return documentOf(place, {
    title: "Gallery · Riverseed",
    description: `${entries.length} maps, each grown from a word. Open one, and change it.`,
    address: "",
    card: first && { file: filesOf(first.slug).card, alt: alternativeOf(first) },
    body: `<header>
      <p><a href="../">Riverseed</a> <span aria-hidden="true">·</span> <a href="../docs/">Documentation</a></p>
      <h1>Gallery</h1>
      <p class="lead">${entries.length} maps, each grown from a word. Open one, and change it.</p>
    </header>
    <main>
      <ul class="maps">
        ${entries.map(itemOf).join("\n        ")}
      </ul>
    </main>`,
  });
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
  const { page, picture, card } = filesOf(entry.slug);
  const onPage = escaped(`../?${entry.link}`);
  return documentOf(place, {
    title: `${entry.title} · Riverseed gallery`,
    description: entry.sentence,
    address: page,
    card: { file: card, alt: alternativeOf(entry) },
    body: `<header>
      <p><a href="../">Riverseed</a> <span aria-hidden="true">/</span> <a href="./">Gallery</a></p>
      <h1>${escaped(entry.title)}</h1>
      <p class="lead">${escaped(entry.sentence)}</p>
    </header>
    <main class="one ${shapeOf(entry)}">
      <a class="picture" href="${onPage}"><img src="${picture}" width="${width}" height="${height}" alt="${escaped(alternativeOf(entry))}" fetchpriority="high" /></a>
      <p><a class="act" href="${onPage}">Open it on the page</a></p>
      <section aria-labelledby="recipe">
        <h2 id="recipe">Its recipe</h2>
        <dl>
          ${entry.settings.map(([label, value]) => `<div><dt>${escaped(label)}</dt> <dd>${escaped(value)}</dd></div>`).join("\n          ")}
        </dl>
        <pre tabindex="0" aria-label="The recipe as a link"><code>${escaped(entry.link)}</code></pre>
      </section>
      <section aria-labelledby="element">
        <h2 id="element">On your own page</h2>
        ${snippetOf(entry, place)}
      </section>
      <nav aria-label="Other maps">
        <a href="${filesOf(around.before.slug).page}" rel="prev">← ${escaped(around.before.title)}</a>
        <a href="./">All maps</a>
        <a href="${filesOf(around.after.slug).page}" rel="next">${escaped(around.after.title)} →</a>
        <a href="../docs/">Documentation</a>
      </nav>
    </main>`,
  });
}

function alternativeOf({ title, style }: Entry): string {
  return `The map ${title}, in the style ${style}`;
}

/** Returns the snippet of the element, or of the picture if the element could not grow everything on it. */
function snippetOf(entry: Entry, { site }: Place): string {
  const base = baseOf(site ?? SOME_SITE);
  const picture = new URL(`gallery/${filesOf(entry.slug).picture}`, base).href;
  const { link, seed, aspect } = entry;
  const code = entry.suitsElement
    ? elementSnippet({ link, seed, aspect, page: base }, picture)
    : pictureSnippet(entry, picture, base);
  const what = entry.suitsElement
    ? "The rivers grow where you paste this:"
    : "There are more rivers here than the element grows on other people’s pages, so this shows their picture:";
  const remark =
    site === undefined ? `<p>Put this site’s address in place of <code>${escaped(SOME_SITE)}</code>.</p>` : "";
  return `<p>${what}</p>
        <pre tabindex="0" aria-label="What to paste"><code>${escaped(code)}</code></pre>
        ${remark}`;
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
  readonly body: string;
}

function documentOf({ site, sheet, hasPolicy }: Place, { title, description, address, card, body }: Content): string {
  const whole = (file: string): string =>
    site === undefined ? `./${file}` : new URL(`gallery/${file}`, baseOf(site)).href;
  const meta = (name: string, content: string | number): string =>
    `<meta ${name.startsWith("og:") ? "property" : "name"}="${name}" content="${escaped(`${content}`)}" />`;
  const head = [
    '<meta charset="utf-8" />',
    '<meta name="viewport" content="width=device-width, initial-scale=1" />',
    `<title>${escaped(title)}</title>`,
    meta("description", description),
    meta("color-scheme", "light dark"),
    meta("og:title", title),
    meta("og:description", description),
    meta("og:type", "website"),
    ...(site === undefined
      ? []
      : [meta("og:url", whole(address)), `<link rel="canonical" href="${whole(address)}" />`]),
    ...(card ? cardOf(whole(card.file), card.alt) : []),
    meta("twitter:card", "summary_large_image"),
    `<link rel="icon" href="${ICON}" />`,
    `<link rel="stylesheet" href="${escaped(sheet)}" />`,
    '<link rel="stylesheet" href="shapes.css" />',
  ];
  function cardOf(image: string, alt: string): string[] {
    return [
      meta("og:image", image),
      meta("og:image:width", CARD.width),
      meta("og:image:height", CARD.height),
      meta("og:image:alt", alt),
    ];
  }
  const policy = hasPolicy ? `<meta http-equiv="Content-Security-Policy" content="${policyFor("")}" />\n    ` : "";
  return `<!doctype html>
<html lang="en">
  <head>
    ${policy}${head.join("\n    ")}
  </head>
  <body>
    ${body}
  </body>
</html>
`;
}
