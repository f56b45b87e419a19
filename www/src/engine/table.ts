/** The parameter table, the presets and the countries. They are data, written by the library (`make docs`). */

import { PageError } from "./errors.ts";
import { limited, SCRIPT_MS } from "./time-limits.ts";
import type { Stage } from "./types.ts";

/** A row of the parameter table. */
export interface Parameter {
  readonly key: string;
  readonly label: string;
  readonly help: string;
  /** The heading it stands under. */
  readonly group: string;
  /** The earliest stage that runs again when it changes. */
  readonly stage: Stage;
  readonly kind: "text" | "integer" | "number" | "choice" | "sides" | "outline";
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly unit?: string;
  readonly scale?: "linear" | "log";
  readonly maxLength?: number;
  readonly choices?: readonly { readonly value: string; readonly label: string }[];
  /** As link text. */
  readonly default: string;
  /** True if the country decides the value that a link leaves out. */
  readonly decided?: true;
}

/** A named set of values; what it leaves out keeps its default. */
export interface Preset {
  readonly name: string;
  readonly label: string;
  readonly help: string;
  readonly values: readonly (readonly [key: string, value: string])[];
}

/** A kind of country, of the values that the key `country` may have. */
export interface Country {
  readonly name: string;
  readonly label: string;
  readonly help: string;
  /** The style that is best on such a map, if it needs one. */
  readonly style?: string;
}

export interface Table {
  readonly parameters: readonly Parameter[];
  /** The presets of links. */
  readonly presets: readonly Preset[];
  /** The kinds of country that words draw. */
  readonly countries: readonly Country[];
}

/** Fetches the table. */
export async function loadTable(): Promise<Table> {
  try {
    const { default: table } = await limited(SCRIPT_MS, "the parameters", () => import("./parameters.json"));
    return table as unknown as Table;
  } catch (error) {
    if (error instanceof PageError) throw error;
    throw new PageError("file-missing", String(error));
  }
}
