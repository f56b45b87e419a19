/** Gives rows of tables that explain a word of code, such as a parameter, an address of their own. */

import type { Token, Tokens } from "marked";

const WORD = /^[a-z][a-z0-9-]*$/i;

/** Returns the names of a table's rows, with nothing for those without one. A page has each name once: `taken` are those that it has. */
export function rowNames({ rows }: Tokens.Table, taken: Set<string>): (string | undefined)[] {
  return rows.map(([first]) => {
    const word = wordOf(first?.tokens ?? []);
    if (word === undefined || taken.has(word)) return undefined;
    taken.add(word);
    return word;
  });
}

/** Returns the word of code that a cell consists of. */
function wordOf([only, ...others]: readonly Token[]): string | undefined {
  return only?.type === "codespan" && others.length === 0 && WORD.test(only.text) ? only.text : undefined;
}
