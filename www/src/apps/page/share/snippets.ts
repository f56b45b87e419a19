/**
 * Snippets that show a river on other pages: as an element, an iframe, or Markdown. Seeds are hostile text, and a
 * snippet is HTML on somebody's site: everything that goes into it is escaped here, once.
 */

import { addressOf } from "../../../browser/address.ts";
import { attributeOf } from "../../../engine/attribute-names.ts";

/** A river to share. */
export interface Shared {
  /** Its canonical link. */
  readonly link: string;
  /** The link for widgets, if it is another: they follow their page's colours where it names no style. */
  readonly widgetLink?: string;
  /** The letters of its names, for an element to carry. */
  readonly letters?: string | undefined;
  readonly seed: string;
  /** Width over height, as a link writes it. */
  readonly aspect: string;
  /** The page's own address: the script and embed.html are beside it. */
  readonly page: string;
}

/** The addresses of the element's script and of the page for iframes, relative to the page. */
const ELEMENT_SCRIPT = "widget/river-seed.js";
const EMBED_PAGE = "embed.html";

/** The width of an iframe where its style is removed; elsewhere it is as wide as its column. */
const IFRAME_WIDTH_PX = 720;

/** Returns the title of a river, for places where its picture is not seen. */
export function titleOf(seed: string): string {
  return seed === "" ? "Rivers" : `Rivers grown from “${seed}”`;
}

/**
 * Returns a link without its style if that is the default one of the page on show: a widget then is dark on dark pages
 * and light on others.
 */
export function withoutDefaultStyle(link: string, style: string): string {
  return link
    .split("&")
    .filter((part) => part !== `style=${style}`)
    .join("&");
}

/**
 * Returns the script and the element. The style reserves the river's space before the script is loaded. Inside is the
 * picture for readers without script or engine, which is beside the post as `picture`; if it was not saved, its text
 * links to this page. `maker` keeps a small link to it on the map.
 */
export function elementSnippet(
  { link, widgetLink = link, letters, seed, aspect, page }: Shared,
  picture: string,
): string {
  const values = [...new URLSearchParams(widgetLink)].map(([key, value]) => [attributeOf(key), value]);
  if (letters) values.push(["letters", letters]);
  const attributes = values.map(([name = "", value = ""]) => ` ${name}="${escaped(value)}"`);
  return [
    `<script type="module" src="${escaped(addressBeside(page, ELEMENT_SCRIPT))}"></script>`,
    `<river-seed${attributes.join("")} maker="${escaped(addressBeside(page, "./"))}" style="display:block;aspect-ratio:${escaped(aspect)};min-height:0;overflow:hidden">`,
    `  <a href="${escaped(addressOf(link, page))}"><img src="${escaped(picture)}"`,
    `    alt="${escaped(titleOf(seed))}" loading="lazy" style="display:block;width:100%"></a>`,
    `</river-seed>`,
  ].join("\n");
}

/** Returns the address of the page for iframes, which shows nothing but the map. */
export function embedAddress({ link, widgetLink = link, page }: Shared): string {
  return addressOf(widgetLink, addressBeside(page, EMBED_PAGE));
}

/**
 * Returns an iframe. Its sandbox lets the embedded page run its scripts with its own origin, and nothing else: no
 * opening windows, no navigating away, no dialogs.
 */
export function iframeSnippet(shared: Shared): string {
  const { seed, aspect } = shared;
  const height = Math.round(IFRAME_WIDTH_PX / Number(aspect));
  return [
    `<iframe src="${escaped(embedAddress(shared))}"`,
    `  title="${escaped(titleOf(seed))}" loading="lazy" sandbox="allow-scripts allow-same-origin"`,
    `  width="${IFRAME_WIDTH_PX}" height="${height}" style="width:100%;height:auto;aspect-ratio:${escaped(aspect)};border:0"></iframe>`,
  ].join("\n");
}

/** Returns the picture, which is beside the post as `picture`, as a link to the page where it grows. */
export function markdownSnippet({ link, seed, page }: Shared, picture: string): string {
  const address = addressOf(link, page).replaceAll("(", "%28").replaceAll(")", "%29");
  return `[![${markdownText(titleOf(seed))}](${picture})](${address})`;
}

/** Returns the address of a file beside the page. */
function addressBeside(page: string, file: string): string {
  const address = new URL(file, page);
  address.search = "";
  address.hash = "";
  return address.href;
}

const ENTITIES: Readonly<Record<string, string>> = {
  "&": "&amp;",
  "<": "&lt;",
  ">": "&gt;",
  '"': "&quot;",
  "'": "&#39;",
};

/** Escapes text for the content of an element and for quoted attributes. */
export function escaped(text: string): string {
  return text.replace(/[&<>"']/g, (sign) => ENTITIES[sign] ?? sign);
}

/** Escapes text for Markdown. CommonMark allows a backslash before any ASCII punctuation. */
function markdownText(text: string): string {
  return text.replace(/[!-/:-@[-`{-~]/g, (sign) => `\\${sign}`);
}
