/** The committed list of digests, with a line for each recipe that begins with its digest. `#` begins a comment. */

export interface Line {
  digest: string;
  link: string;
}

export function linesOf(text: string): Line[] {
  return text
    .split("\n")
    .filter((line) => line !== "" && !line.startsWith("#"))
    .map((line) => ({ digest: line.slice(0, line.indexOf(" ")), link: line.slice(line.indexOf(" ") + 1).trim() }));
}

/** The number of parts that the lines are tried in, each within the time that a test has. */
export const PARTS = 3;

/** Returns every third line, from that of a number on; all lines without one. */
export function partOf(lines: readonly Line[], first: string | null): readonly Line[] {
  return first === null ? lines : lines.filter((_, i) => i % PARTS === Number(first));
}
