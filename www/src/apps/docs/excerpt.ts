/** Cuts from a text what shows why it was found. */

/** A piece of text; `isHit` if it is one of the words that were sought. */
export interface Piece {
  readonly text: string;
  readonly isHit: boolean;
}

/** The length of an excerpt, and how much of it stands before the first hit. */
const LENGTH = 150;
const BEFORE = 40;

/** Returns the part around the first hit of the first text that has one, whole words only. */
export function excerptOf(texts: readonly string[], words: readonly string[]): Piece[] {
  const pattern = patternOf(words);
  const text = texts.find((one) => one.search(pattern) >= 0) ?? texts[0] ?? "";
  const first = text.search(pattern);
  const from = first <= BEFORE ? 0 : text.indexOf(" ", first - BEFORE) + 1;
  const end = from + LENGTH;
  const to = end >= text.length ? text.length : Math.max(text.lastIndexOf(" ", end), from);
  const before = from > 0 ? "… " : "";
  const after = to < text.length ? " …" : "";
  return piecesOf(before + text.slice(from, to) + after, words);
}

/** Divides a text into words that were sought and what is between. */
export function piecesOf(text: string, words: readonly string[]): Piece[] {
  return text
    .split(patternOf(words))
    .map((part, i) => ({ text: part, isHit: i % 2 === 1 }))
    .filter((piece) => piece.text !== "");
}

/** Returns a pattern of the words, at the beginnings of words, that keeps them when a text is split by it. */
function patternOf(words: readonly string[]): RegExp {
  const literal = words.map((word) => word.replace(/[\\^$.*+?()[\]{}|]/g, "\\$&")).sort((a, b) => b.length - a.length);
  return literal.length === 0 ? /($^)/ : new RegExp(`(?<![\\p{L}\\p{N}])(${literal.join("|")})`, "giu");
}
