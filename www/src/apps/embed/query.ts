/** The query of embed.html: a river's link, and beside it how the element is to behave. */

/** What the query may say besides the recipe; the names and values are the element's attributes. */
const ATTRIBUTES: readonly string[] = ["controls", "still", "theme"];

export interface EmbedQuery {
  /** Link text. */
  readonly recipe: string;
  /** Of names given twice the first counts, as in links. */
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
