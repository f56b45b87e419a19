/** How values are written in a link. */

/** Values as link text, for the core to read. Spaces as %20: one spelling, whatever reads it. */
export function linkText(values: Iterable<readonly [key: string, value: string]>): string {
  const query = new URLSearchParams();
  for (const [key, value] of values) query.append(key, value);
  return query.toString().replaceAll("+", "%20");
}
