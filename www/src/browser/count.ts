/** Numbers for people. */

/** How numbers are written. */
export type Count = (value: number) => string;

let format: Intl.NumberFormat | undefined;

/** A number for people: 12,000. */
export function count(value: number): string {
  // Made when it is first needed: that takes the browser longer than all else that a widget does at its start.
  format ??= new Intl.NumberFormat("en");
  return format.format(value);
}
