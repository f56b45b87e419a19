/** Divides pages into sections for the search. */

import type { Section } from "../../src/apps/docs/section.ts";
import type { Article } from "./article.ts";
import { addressOf } from "./contents.ts";
import { wordsOf } from "./plain.ts";

/** The lowest rank of headings that begin a section of their own. */
const DEEPEST = 3;

/** Returns the sections of a page in their order. */
export function sectionsOf(article: Article): Section[] {
  const page = addressOf(article.source);
  const sections: (Pick<Section, "address" | "heading"> & { text: string[]; code: string[] })[] = [];
  for (const { token, heading } of article.blocks) {
    if (heading && heading.depth <= DEEPEST) {
      const address = heading.depth === 1 ? page : `${page}#${heading.id}`;
      sections.push({ address, heading: heading.text, text: [], code: [] });
    } else sections.at(-1)?.[token.type === "code" ? "code" : "text"].push(wordsOf([token]));
  }
  return sections.map(({ text, code, ...section }) => ({
    ...section,
    page: article.title,
    text: joined(text),
    code: joined(code),
  }));
}

function joined(parts: readonly string[]): string {
  return parts.filter((part) => part !== "").join(" ");
}
