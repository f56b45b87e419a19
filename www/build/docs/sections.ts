/** Divides pages into sections for the search. */

import type { Tokens } from "marked";
import type { Section } from "../../src/apps/docs/section.ts";
import type { Article } from "./article.ts";
import { addressOf } from "./contents.ts";
import { wordsOf } from "./plain.ts";

/** The lowest rank of headings that begin a section of their own. */
const DEEPEST = 3;

/** A section while its parts are put together. */
interface Parts extends Pick<Section, "address" | "heading"> {
  readonly text: string[];
  readonly code: string[];
}

/** Returns the sections of a page in their order. A row of a table that has an address is a section of its own. */
export function sectionsOf(article: Article): Section[] {
  const page = addressOf(article.source);
  const sections: Parts[] = [];
  const rows: Parts[] = [];
  const begin = (list: Parts[], address: string, heading: string, text: string[] = []) =>
    list.push({ address, heading, text, code: [] });
  for (const { token, heading, rows: names } of article.blocks) {
    const section = sections.at(-1);
    if (heading && heading.depth <= DEEPEST)
      begin(sections, heading.depth === 1 ? page : `${page}#${heading.id}`, heading.text);
    else if (token.type === "code") section?.code.push(wordsOf([token]));
    else if (!names) section?.text.push(wordsOf([token]));
    else
      for (const [i, [first, ...others]] of (token as Tokens.Table).rows.entries()) {
        const name = names[i];
        if (name === undefined) section?.text.push(cellsOf([...(first ? [first] : []), ...others]));
        else begin(rows, `${page}#${name}`, name, [cellsOf(others)]);
      }
  }
  return [...sections, ...rows].map(({ text, code, ...section }) => ({
    ...section,
    page: article.title,
    text: joined(text, " "),
    code: joined(code, " "),
  }));
}

function cellsOf(cells: readonly Tokens.TableCell[]): string {
  return joined(
    cells.map(({ tokens }) => wordsOf(tokens)),
    " · ",
  );
}

function joined(parts: readonly string[], between: string): string {
  return parts.filter((part) => part !== "").join(between);
}
