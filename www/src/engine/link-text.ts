/** The spelling of values in a link. */

/** Writes values as link text for the core. Spaces become %20, which every reader understands. */
export function linkText(values: Iterable<readonly [key: string, value: string]>): string {
  const query = new URLSearchParams();
  for (const [key, value] of values) query.append(key, value);
  return query.toString().replaceAll("+", "%20");
}

/** The value of a key that a word is to decide; leaving the key out says the same. */
export const AUTO = "auto";

/** Returns a link with some values changed. */
export function changed(link: string, changes: Iterable<readonly [key: string, value: string]>): string {
  return linkText(new Map([...new URLSearchParams(link), ...changes]));
}
