/** All controls of the recipe but the seed, generated from the parameter table, under the table's own headings. */

import { el } from "../browser/dom.ts";
import type { Parameter } from "../engine/full.ts";
import { type Control, control } from "./control.ts";
import type { Disclosures } from "./disclosure.ts";
import { type Group, group } from "./group.ts";
import { keysOf, MACROS, macroControl } from "./macros.ts";
import type { Padlocks } from "./padlocks.ts";
import { rangeOf } from "./values.ts";

export interface Controls {
  readonly element: HTMLElement;
  show(values: Values): void;
}

/** By key: the values on show, the defaults of the page, and why some do nothing. */
export interface Values {
  values: ReadonlyMap<string, string>;
  defaults: ReadonlyMap<string, string>;
  idle: ReadonlyMap<string, string>;
}

/** A parameter with one possible value (the edition) has nothing to set; the seed has a box of its own, an outline is drawn. */
export function isAdjustable(parameter: Parameter): boolean {
  const range = rangeOf(parameter);
  return parameter.key !== "seed" && parameter.kind !== "outline" && !(range && range.min === range.max);
}

/** Told several keys and their new values as link text, which are one change. */
export type ChangeOfMany = (values: readonly (readonly [key: string, text: string])[]) => void;

/** `own` has, by key, controls that are made elsewhere. */
export function controls(
  table: readonly Parameter[],
  change: ChangeOfMany,
  disclosures: Disclosures,
  padlocks: Padlocks,
  own: ReadonlyMap<string, Control> = new Map(),
): Controls {
  const made = new Map<string, Control>();
  const groups: Group[] = [];
  const make = (parameter: Parameter): Control => {
    const one = own.get(parameter.key) ?? control(parameter, (key, text) => change([[key, text]]));
    made.set(parameter.key, one);
    return one;
  };
  const adjustable = table.filter(isAdjustable);
  const byKey = new Map(adjustable.map((parameter) => [parameter.key, parameter]));
  const macros = new Map(MACROS.map((macro) => [macro.name, { macro, ...macroControl(macro, byKey, change) }]));
  const front = FRONT.flatMap(([key, label]) => {
    const { macro, element } = macros.get(key) ?? {};
    if (macro && element) return locked(element, padlocks.padlock(macro.label, keysOf(macro)));
    const parameter = byKey.get(key);
    return parameter ? locked(make({ ...parameter, label }).element, padlocks.padlock(label, [key])) : [];
  });
  for (const [heading, all] of grouped(adjustable)) {
    const parameters = all.filter(({ key }) => !made.has(key));
    parameters.forEach(make);
    // What of it stands in front is kept with the rest.
    const padlock = padlocks.padlock(`all of ${heading}`, keysUnder(heading, table));
    groups.push(group(heading, parameters, made, disclosures, padlock));
  }
  return {
    element: el(
      "div",
      { class: "groups" },
      el("div", { class: "front members" }, ...front),
      ...groups.map(({ element }) => element),
    ),
    show({ values, defaults, idle }) {
      for (const [key, one] of made) {
        const text = values.get(key);
        if (text !== undefined) one.show(text, defaults.get(key) ?? "", idle.get(key));
      }
      for (const one of macros.values()) one.show(values, defaults);
      for (const one of groups) one.show(values, defaults);
    },
  };
}

/** What shapes a map most, in the words of whoever wants one: parameters and macros. All else stands under its heading. */
export const FRONT: readonly (readonly [name: string, label: string])[] = [
  ["land", "Land"],
  ["sea", "How much sea"],
  ["roughness", "How wild a coast"],
  ["rivers", ""],
  ["attractors", "How fine"],
  ["winding", ""],
  ["width", "How wide"],
];

/** A control with its padlock. */
function locked(control: HTMLElement, padlock: HTMLElement): HTMLElement {
  control.querySelector(".control-head label")?.after(padlock);
  return control;
}

/** All values under a heading, those too that have their control elsewhere, such as a drawn coast. */
function keysUnder(heading: string, table: readonly Parameter[]): string[] {
  return table.filter(({ group }) => group === heading).map(({ key }) => key);
}

/** What applies however rivers grow, then what the default way uses; the others follow in the table's order. */
const FIRST = ["Land", "Growth", "Drainage"];

/** Parameters by their headings, in the order of the panel. */
export function grouped(table: readonly Parameter[]): Map<string, Parameter[]> {
  const headings = new Set([...FIRST, ...table.map(({ group }) => group)]);
  const members = (heading: string) => table.filter(({ group }) => group === heading);
  return new Map([...headings].map((heading) => [heading, members(heading)]));
}
