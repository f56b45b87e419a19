/** Words for what has a name, or could have one. */

import type { Kind } from "../../../engine/mark.ts";
import type { Nameable } from "../../page-worker/protocol.ts";

const ARTICLES: Partial<Record<Kind, string>> = { island: "An" };
const WORDS: Record<Kind, string> = {
  map: "map",
  river: "river",
  reach: "stretch of a river",
  sea: "sea",
  lake: "lake",
  land: "land",
  island: "island",
  bay: "bay",
  cape: "cape",
  strait: "strait",
  range: "mountain range",
};

/** Returns the word for a kind of thing. */
export function wordFor(kind: Kind): string {
  return WORDS[kind];
}

/** Returns the word for one thing, which its name may know better: marks do not tell a gulf from a bay. */
function wordOf({ kind, name }: Nameable): string {
  return kind === "bay" && /\bgulf\b/i.test(name) ? "gulf" : wordFor(kind);
}

/** Returns the name of something that is no river, or a phrase if it has none, and what it is. */
export function titleOfPlace(thing: Nameable): [title: string, description: string] {
  const { kind, name } = thing;
  const article = ARTICLES[kind] ?? "A";
  const word = wordOf(thing);
  if (name === "") return [`${article} ${word} without a name`, ""];
  return [name, kind === "land" || kind === "map" ? `The name of this ${word}` : `${article} ${word}`];
}

/** Returns the words on a button for something else that is at the same place. */
export function choiceOf(thing: Nameable): string {
  const { name } = thing;
  const word = wordOf(thing);
  return name === "" ? `the ${word}` : `${name}, the ${word}`;
}
