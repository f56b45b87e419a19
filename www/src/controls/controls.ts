/** The controls of the recipe except the seed, generated from the parameter table under its headings. */

import { el } from "../browser/dom.ts";
import type { Parameter } from "../engine/table.ts";
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

/** Values by key: those on show, the defaults of the page, and the reasons why some have no effect. */
export interface Values {
  values: ReadonlyMap<string, string>;
  defaults: ReadonlyMap<string, string>;
  idle: ReadonlyMap<string, string>;
}

/**
 * Returns whether a parameter gets a control here. One with a single possible value (the edition) does not; the seed
 * has its own box, and an outline is drawn.
 */
export function isAdjustable(parameter: Parameter): boolean {
  const range = rangeOf(parameter);
  return parameter.key !== "seed" && parameter.kind !== "outline" && !(range && range.min === range.max);
}

/** Returns the value that a parameter's 0 stands for on the map that is shown. */
function automaticValue(parameter: Parameter | undefined, values: Values["values"]): string | undefined {
  const { key = "", automatic } = parameter ?? {};
  if (!automatic || values.get(key) !== "0") return undefined;
  return automatic.values[values.get(automatic.by) ?? ""];
}

/** Takes one change of several keys, with their new values as link text. */
export type ChangeOfMany = (values: readonly (readonly [key: string, text: string])[]) => void;

/** Makes the controls. `own` contains, by key, controls that are made elsewhere. */
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
    // This padlock includes the parameters that are shown in front.
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
        if (text === undefined) continue;
        one.show(text, defaults.get(key) ?? "", idle.get(key), automaticValue(byKey.get(key), values));
      }
      for (const one of macros.values()) one.show(values, defaults);
      for (const one of groups) one.show(values, defaults);
    },
  };
}

/** The parameters and macros that shape a map most, in everyday words. All others are under their headings. */
export const FRONT: readonly (readonly [name: string, label: string])[] = [
  ["land", "Land"],
  ["sea", "How much sea"],
  ["roughness", "How wild a coast"],
  ["rivers", ""],
  ["attractors", "How fine"],
  ["winding", ""],
  ["width", "How wide"],
];

/** Puts a padlock into a control. */
function locked(control: HTMLElement, padlock: HTMLElement): HTMLElement {
  control.querySelector(".control-head label")?.after(padlock);
  return control;
}

/** Returns all keys under a heading, including those with a control elsewhere, such as a drawn coast. */
function keysUnder(heading: string, table: readonly Parameter[]): string[] {
  return table.filter(({ group }) => group === heading).map(({ key }) => key);
}

/**
 * The first headings: those that apply however rivers grow, then that of the default growth. The others follow in the
 * table's order.
 */
const FIRST = ["Land", "Growth", "Drainage"];

/** Groups parameters by heading, in the order of the panel. */
export function grouped(table: readonly Parameter[]): Map<string, Parameter[]> {
  const headings = new Set([...FIRST, ...table.map(({ group }) => group)]);
  const members = (heading: string) => table.filter(({ group }) => group === heading);
  return new Map([...headings].map((heading) => [heading, members(heading)]));
}
