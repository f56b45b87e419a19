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

/** Returns a part of the lines: every third, the others, or all of them if it has no such name. */
export function partOf(lines: readonly Line[], part: string | null): Line[] {
  if (part === "third") return lines.filter((_, i) => i % 3 === 0);
  return part === "others" ? lines.filter((_, i) => i % 3 !== 0) : [...lines];
}
