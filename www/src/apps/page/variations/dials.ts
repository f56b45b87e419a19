/** The dials of variations: what stands in front in the panel, each moved by an amount that the eye sees. */

import { FRONT } from "../../../controls/controls.ts";
import { MACROS, placeOf, valuesAt } from "../../../controls/macros.ts";
import { nearestText, placeText, rangeOf, share } from "../../../controls/values.ts";
import type { Parameter } from "../../../engine/table.ts";

export type Values = readonly (readonly [key: string, text: string])[];

/** A dial, and the values of the map on which it is moved. */
export interface Dial {
  /** The words for a move up and down. */
  more: string;
  less: string;
  /** The least and the most that it is moved, in shares of its way. */
  least: number;
  most: number;
  /** The place where it stands, from 0 to 1. */
  place: number;
  /** Returns what a move to another place changes. */
  at(place: number): Values;
}

/** How a dial is moved: by its name in the panel. A land of another kind would be another map, so it is none of them. */
const MOVES: Readonly<Record<string, Omit<Dial, "place" | "at">>> = {
  sea: { more: "more sea", less: "less sea", least: 0.05, most: 0.12 },
  roughness: { more: "wilder coast", less: "calmer coast", least: 0.3, most: 0.6 },
  rivers: { more: "more rivers", less: "fewer rivers", least: 0.18, most: 0.35 },
  attractors: { more: "finer", less: "coarser", least: 0.05, most: 0.1 },
  winding: { more: "more winding", less: "less winding", least: 0.2, most: 0.4 },
  width: { more: "wider rivers", less: "narrower rivers", least: 0.1, most: 0.25 },
};

/** The map that is varied. */
export interface Varied {
  /** Its link, with the style that is shown. */
  link: string;
  values: ReadonlyMap<string, string>;
  /** The reasons why values have no effect on it, by key. */
  idle: ReadonlyMap<string, string>;
  /** The keys of values that are to stay. */
  kept: ReadonlySet<string>;
}

/** Returns the dials that can be moved on a map: those with an effect, and not all of whose values are kept. */
export function dialsOf(map: Varied, table: ReadonlyMap<string, Parameter>): Dial[] {
  return FRONT.flatMap(([name]) => {
    const move = MOVES[name];
    const turned = move && (turnedMacro(name, map, table) ?? turnedParameter(table.get(name), map));
    if (!turned) return [];
    const at = (place: number): Values => turned.at(place).filter(([key, text]) => isChange(key, text, map));
    const { place } = turned;
    // One that changes nothing at either end has no effect.
    return [0, 1].some((end) => at(end).length > 0) ? [{ ...move, place, at }] : [];
  });
}

type Turned = Pick<Dial, "place" | "at">;

function turnedMacro(name: string, { values }: Varied, table: ReadonlyMap<string, Parameter>): Turned | undefined {
  const macro = MACROS.find((one) => one.name === name);
  return macro && { place: placeOf(macro, values), at: (place) => valuesAt(macro, place, table, values) };
}

function turnedParameter(parameter: Parameter | undefined, { values }: Varied): Turned | undefined {
  const range = parameter && rangeOf(parameter);
  if (!range) return undefined;
  const { key } = parameter;
  return {
    place: share(Number(nearestText(Number(values.get(key)), range)), range),
    at: (place) => [[key, placeText(place, range)]],
  };
}

function isChange(key: string, text: string, { values, idle, kept }: Varied): boolean {
  return !kept.has(key) && !idle.has(key) && values.get(key) !== text;
}
