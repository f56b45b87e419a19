/** Writes numbers for people. */

/** A way to write numbers. */
export type Count = (value: number) => string;

let format: Intl.NumberFormat | undefined;

/** Writes a number for people: 12,000. */
export function count(value: number): string {
  // Made on first use: it takes the browser longer than everything else that a widget does at its start.
  format ??= new Intl.NumberFormat("en");
  return format.format(value);
}
