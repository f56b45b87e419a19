/** The spelling of values in a link. */

/** Writes values as link text for the core. Spaces become %20, which every reader understands. */
export function linkText(values: Iterable<readonly [key: string, value: string]>): string {
  const query = new URLSearchParams();
  for (const [key, value] of values) query.append(key, value);
  return query.toString().replaceAll("+", "%20");
}
