/** Shows what was found as a list of links. Everything in it is text: the question and the pages are never read as HTML. */

import { excerptOf, type Piece, piecesOf } from "./excerpt.ts";
import type { Found } from "./index.ts";

/** Writes the results into a list. `way` leads from this page to the folder of the pages. */
export function showResults(list: HTMLElement, results: readonly Found[], way: string): void {
  list.replaceChildren(...results.map((result) => itemOf(result, way)));
}

function itemOf({ address, page, heading, text, code, words }: Found, way: string): HTMLElement {
  const link = document.createElement("a");
  link.href = `./${way}${address}`;
  const place = heading === page ? [] : [spanOf("found-page", piecesOf(page, words))];
  link.append(
    spanOf("found-heading", piecesOf(heading, words)),
    ...place,
    spanOf("found-text", excerptOf([text, code], words)),
  );
  const item = document.createElement("li");
  item.append(link);
  return item;
}

function spanOf(name: string, pieces: readonly Piece[]): HTMLElement {
  const span = document.createElement("span");
  span.className = name;
  span.append(...pieces.map(nodeOf));
  return span;
}

function nodeOf({ text, isHit }: Piece): Node | string {
  if (!isHit) return text;
  const mark = document.createElement("mark");
  mark.textContent = text;
  return mark;
}

/** Returns the number of results in words. */
export function countOf(results: readonly unknown[], question: string): string {
  if (results.length === 0) return `Nothing found for “${question}”.`;
  return results.length === 1 ? "1 result" : `${results.length} results`;
}
