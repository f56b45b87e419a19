/** The query of embed.html: a river's link, and attributes of the element. */

/** The attributes that the query may contain besides the recipe, with the element's names and values. */
const ATTRIBUTES: readonly string[] = ["controls", "speed", "still", "theme"];

export interface EmbedQuery {
  /** Link text. */
  readonly recipe: string;
  /** The element's attributes. If a name is given twice the first counts, as in links. */
  readonly attributes: ReadonlyMap<string, string>;
}

export function readQuery(query: string): EmbedQuery {
  const recipe: string[] = [];
  const attributes = new Map<string, string>();
  for (const part of query.split("&")) {
    const [given] = new URLSearchParams(part);
    if (!given || !ATTRIBUTES.includes(given[0])) recipe.push(part);
    else if (!attributes.has(given[0])) attributes.set(...given);
  }
  return { recipe: recipe.join("&"), attributes };
}
