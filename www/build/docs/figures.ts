/** Writes the pictures of documents with their sizes, so that nothing moves when they come. */

import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import type { Tokens } from "marked";
import { escaped } from "../../src/apps/page/share/snippets.ts";
import type { Size } from "../../src/browser/canvas.ts";
import type { Article } from "./article.ts";
import { addressOf, REPOSITORY, wayUp } from "./contents.ts";

/** A picture as HTML, with its path in the repository, or what is wrong with it. */
type Figure = { readonly html: string; readonly source: string } | { readonly fault: string };

export function figureOf({ href, text }: Tokens.Image, article: Article): Figure {
  const source = posix.join(posix.dirname(article.source), href);
  if (!/^docs\/.*\.(svg|png)$/.test(source)) return { fault: `${href} is no SVG or PNG in docs` };
  const size = sizeOf(source);
  if (!size) return { fault: `${href} cannot be read, or has no size` };
  const address = wayUp(addressOf(article.source)) + source.replace(/^docs\//, "");
  const html = `<img src="${escaped(address)}" width="${size.width}" height="${size.height}" alt="${escaped(text)}" loading="lazy" />`;
  return { html, source };
}

function sizeOf(source: string): Size | undefined {
  try {
    const file = readFileSync(join(REPOSITORY, source));
    return source.endsWith(".png")
      ? { width: file.readUInt32BE(16), height: file.readUInt32BE(20) }
      : sizeOfSvg(`${file}`);
  } catch {
    return undefined;
  }
}

function sizeOfSvg(svg: string): Size | undefined {
  const [, width, height] = /<svg[^>]* viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(svg) ?? [];
  return width && height ? { width: Math.round(Number(width)), height: Math.round(Number(height)) } : undefined;
}
