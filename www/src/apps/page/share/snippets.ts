/**
 * What others paste to show a river: as an element, as an iframe, as Markdown. Seeds are hostile text, and a snippet is
 * HTML on somebody's site: whatever goes in is escaped here, once.
 */

import { addressOf } from "../../../browser/address.ts";
import { attributeOf } from "../../../engine/attribute-names.ts";

/** A river that is to be shared. */
export interface Shared {
  /** Its canonical link. */
  readonly link: string;
  readonly seed: string;
  /** Width over height, as the link would have it. */
  readonly aspect: string;
  /** The page's own address: script and embed.html lie beside it. */
  readonly page: string;
}

/** Where the built site keeps the element's script and the page for iframes, seen from its page. */
const ELEMENT_SCRIPT = "widget/river-seed.js";
const EMBED_PAGE = "embed.html";

/** An iframe's width where its style is not let through; elsewhere it is as wide as its column. */
const IFRAME_WIDTH_PX = 720;

/** What a river is called where its picture is not seen. */
export function titleOf(seed: string): string {
  return seed === "" ? "Rivers" : `Rivers grown from “${seed}”`;
}

/**
 * The script and the element. Its style keeps the river's room before the script has come, whatever stands inside: the picture,
 * which lies beside the post as `picture`, for readers without script or engine; where it was not saved, its text, which leads here.
 */
export function elementSnippet({ link, seed, aspect, page }: Shared, picture: string): string {
  const attributes = [...new URLSearchParams(link)].map(([key, value]) => ` ${attributeOf(key)}="${escaped(value)}"`);
  return [
    `<script type="module" src="${escaped(addressBeside(page, ELEMENT_SCRIPT))}"></script>`,
    `<river-seed${attributes.join("")} style="display:block;aspect-ratio:${escaped(aspect)};min-height:0;overflow:hidden">`,
    `  <a href="${escaped(addressOf(link, page))}"><img src="${escaped(picture)}"`,
    `    alt="${escaped(titleOf(seed))}" loading="lazy" style="display:block;width:100%"></a>`,
    `</river-seed>`,
  ].join("\n");
}

/**
 * The sandbox lets the embedded page run its script as itself, and keeps it from anything else: opening windows, leading
 * the reader away, asking questions.
 */
export function iframeSnippet({ link, seed, aspect, page }: Shared): string {
  const address = addressOf(link, addressBeside(page, EMBED_PAGE));
  const height = Math.round(IFRAME_WIDTH_PX / Number(aspect));
  return [
    `<iframe src="${escaped(address)}"`,
    `  title="${escaped(titleOf(seed))}" loading="lazy" sandbox="allow-scripts allow-same-origin"`,
    `  width="${IFRAME_WIDTH_PX}" height="${height}" style="width:100%;height:auto;aspect-ratio:${escaped(aspect)};border:0"></iframe>`,
  ].join("\n");
}

/** The picture, which lies beside the post as `picture`, leading to the page where it grows. */
export function markdownSnippet({ link, seed, page }: Shared, picture: string): string {
  const address = addressOf(link, page).replaceAll("(", "%28").replaceAll(")", "%29");
  return `[![${markdownText(titleOf(seed))}](${picture})](${address})`;
}

/** The address of a file that lies beside the page. */
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

/** Text that stays text, as the content of an element and between quotation marks. */
export function escaped(text: string): string {
  return text.replace(/[&<>"']/g, (sign) => ENTITIES[sign] ?? sign);
}

/** CommonMark takes a backslash before any punctuation of ASCII, and shows the punctuation. */
function markdownText(text: string): string {
  return text.replace(/[!-/:-@[-`{-~]/g, (sign) => `\\${sign}`);
}
