/** The parameter table, the presets and the countries. */

import { table } from "../build/table.ts";
import type { Parameter } from "../src/engine/table.ts";

export { table };

/** The table's row of a key. */
export function parameter(key: string): Parameter {
  const row = table.parameters.find((one) => one.key === key);
  if (!row) throw new Error(`the table has no ${key}`);
  return row;
}
