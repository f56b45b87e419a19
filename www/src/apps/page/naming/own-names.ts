/** Names of one's own: which of them a change of the recipe lets go. */

import { AUTO } from "../../../engine/link-text.ts";

type Values = ReadonlyMap<string, string>;
type Changes = readonly (readonly [key: string, value: string])[];

/** The keys that decide where rivers, coasts and islands are at all. Others move them at most. */
const COUNTRY: readonly string[] = ["seed", "country", "land"];
/** The keys that limit which countries the word may draw, so that a new value may give another one. */
const LIMITS: readonly string[] = ["pattern", "growth"];

/**
 * Returns the changes of a recipe, and with them that of its own names: they belong to seed and land, and would name
 * nothing of another country. Changes that bring names keep those. `asked` is what the link says, and `values` what is
 * drawn.
 */
export function withoutForeignNames(changes: Changes, { asked, values }: { asked: Values; values: Values }): Changes {
  const is = (all: Values, key: string, value: string): boolean => small(all.get(key)) === small(value);
  const isNew = (key: string, value: string): boolean => !is(asked, key, value) && !is(values, key, value);
  const deciding = asked.get("country") === AUTO ? [...COUNTRY, ...LIMITS] : COUNTRY;
  const isOther = changes.some(([key, value]) => deciding.includes(key) && isNew(key, value));
  const bringsNames = changes.some(([key]) => key === "names");
  return isOther && !bringsNames && values.get("names") ? [...changes, ["names", ""]] : changes;
}

/** Returns a text in small letters: case does not count in a seed. Where it does, in rare alphabets, names that are kept name nothing. */
function small(text = ""): string {
  return text.toLowerCase();
}

/** Returns whether the parameter `names` gives something a name. */
export function isOwnName(names: string, mark: string): boolean {
  return names.split("_").some((one) => one.startsWith(`${mark}.`));
}
