/** The mark of the first tier in a test's title: `make test` runs those tests, `make test-all` the others too. */
const CORE = " @core";

/** Marks a test of a row of tests that differ in a size, a colour or an input: one or two of such a row stand for all of it. */
export function core(isChosen: boolean): string {
  return isChosen ? CORE : "";
}
