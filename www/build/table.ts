/** The parameter table, the presets and the countries, for the build. */

import json from "../src/engine/parameters.json" with { type: "json" };
import type { Table } from "../src/engine/table.ts";

export const table = json as unknown as Table;
