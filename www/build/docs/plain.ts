/** The words of Markdown without its marks: for headings, descriptions and the search. */

import type { Token, Tokens } from "marked";

/** Returns the words of tokens, with cells and items apart. */
export function wordsOf(tokens: readonly Token[]): string {
  return tokens.map(wordsOfOne).join("").replace(/\s+/g, " ").trim();
}

function wordsOfOne(token: Token): string {
  switch (token.type) {
    case "html":
    case "image":
      return "";
    case "br":
    case "space":
      return " ";
    case "table":
      return rowsOf(token as Tokens.Table)
        .map((row) => row.map((cell) => wordsOf(cell.tokens)).join(" · "))
        .join("\n")
        .concat("\n");
    case "list":
      return (token as Tokens.List).items.map((item) => `${wordsOf(item.tokens)}\n`).join("");
    case "paragraph":
    case "heading":
    case "blockquote":
      return `${wordsOf(token.tokens ?? [])}\n`;
    case "code":
      return `${(token as Tokens.Code).text}\n`;
    default:
      if (token.type !== "text" || !("tokens" in token)) return "text" in token ? String(token.text) : token.raw;
      return (token.tokens ?? []).map(wordsOfOne).join("");
  }
}

function rowsOf({ header, rows }: Tokens.Table): Tokens.TableCell[][] {
  return [header, ...rows];
}
