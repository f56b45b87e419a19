/** A document of the repository, taken apart: its title, its headings, and the line on which each part begins. */

import { Lexer, type Token, type Tokens } from "marked";
import { anchors } from "./anchors.ts";
import { wordsOf } from "./plain.ts";
import { rowNames } from "./rows.ts";

export interface Heading {
  /** Its name in addresses. */
  readonly id: string;
  readonly depth: number;
  readonly text: string;
}

/** A token that is not inside another one. */
export interface Block {
  readonly token: Token;
  /** The line on which it begins, counted from 1. */
  readonly line: number;
  /** The heading that it is, if it is one. */
  readonly heading?: Heading;
  /** The names in addresses of the rows that it has, if it is a table. */
  readonly rows?: readonly (string | undefined)[];
}

export interface Article {
  /** Its path in the repository. */
  readonly source: string;
  /** The first heading, which no other may be equal in rank to. */
  readonly title: string;
  /** The first paragraph in words. */
  readonly lead: string;
  readonly blocks: readonly Block[];
  readonly headings: readonly Heading[];
}

/** Takes a document apart. Throws an error that names the file if it has no title. */
export function articleOf(source: string, text: string): Article {
  const nameOf = anchors();
  let line = 1;
  const blocks = new Lexer().lex(text).map((token): Block => {
    const block = {
      token,
      line,
      ...(token.type === "heading" && { heading: headingOf(token as Tokens.Heading, nameOf) }),
    };
    line += token.raw.split("\n").length - 1;
    return block;
  });
  const headings = blocks.flatMap(({ heading }) => heading ?? []);
  const [title, ...others] = headings.filter(({ depth }) => depth === 1);
  if (!title || others.length > 0) throw new Error(`${source}: a page has one heading of the first rank, its title`);
  const taken = new Set(headings.map(({ id }) => id));
  const lead = blocks.find(({ token }) => token.type === "paragraph");
  return {
    source,
    title: title.text,
    lead: wordsOf(lead ? [lead.token] : []),
    blocks: blocks.map((block) => withRows(block, taken)),
    headings,
  };
}

function withRows(block: Block, taken: Set<string>): Block {
  return block.token.type === "table" ? { ...block, rows: rowNames(block.token as Tokens.Table, taken) } : block;
}

function headingOf({ depth, tokens }: Tokens.Heading, nameOf: (heading: string) => string): Heading {
  const text = wordsOf(tokens);
  return { id: nameOf(text), depth, text };
}
