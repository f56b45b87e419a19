/** Marks, by which the parameter `names` of a link knows what has a name. */

/** The kinds of things that have names or could have one. */
export type Kind = "map" | "river" | "reach" | "sea" | "lake" | "land" | "island" | "bay" | "cape" | "strait" | "range";

/** The kinds by the letters that their marks begin with. A river's mark is a number. */
const KINDS: Readonly<Record<string, Kind>> = {
  t: "map",
  m: "reach",
  s: "sea",
  l: "lake",
  i: "island",
  b: "bay",
  c: "cape",
  n: "strait",
  h: "range",
};

/** Returns the kind of thing that a mark stands for. */
export function kindOf(mark: string): Kind {
  return mark === "i0" ? "land" : (KINDS[mark.charAt(0)] ?? "river");
}
