/**
 * The controls of the recipe except the seed and the names, generated from the parameter table: in front what shapes a
 * map most, and under *All settings* the other parameters by their headings.
 */

import { el } from "../browser/dom.ts";
import type { Parameter } from "../engine/table.ts";
import { type Control, control, frontControl } from "./control.ts";
import type { Disclosures } from "./disclosure.ts";
import { group } from "./group.ts";
import { keysOf, MACROS, type MacroControl, macroControl } from "./macros.ts";
import type { Padlocks } from "./padlocks.ts";
import { Settings } from "./settings.ts";
import { rangeOf } from "./values.ts";

export interface Controls {
  /** The parameters and macros in front. */
  readonly front: HTMLElement;
  /** All settings, folded away. */
  readonly settings: HTMLElement;
  show(values: Values): void;
}

/**
 * Values by key: those on show, what the link says of them and what it says by default, and the reasons why some have no
 * effect.
 */
export interface Values {
  values: ReadonlyMap<string, string>;
  asked: ReadonlyMap<string, string>;
  defaults: ReadonlyMap<string, string>;
  idle: ReadonlyMap<string, string>;
}

/**
 * Returns whether a parameter gets a control in the panel. One with a single possible value (the edition) does not; the
 * seed has its own box, and an outline is drawn.
 */
export function isAdjustable(parameter: Parameter): boolean {
  const range = rangeOf(parameter);
  return parameter.key !== "seed" && parameter.kind !== "outline" && !(range && range.min === range.max);
}

/** Returns the value that is decided elsewhere than in the link, if it is. */
export function automaticValue(key: string, { values, asked }: Pick<Values, "values" | "asked">): string | undefined {
  const value = values.get(key);
  return value === asked.get(key) ? undefined : value;
}

/** Takes one change of several keys, with their new values as link text. */
export type ChangeOfMany = (values: readonly (readonly [key: string, text: string])[]) => void;

/** The parameters and macros that shape a map most, in everyday words. */
export const FRONT: readonly (readonly [name: string, label: string])[] = [
  ["land", "Land"],
  ["sea", "How much sea"],
  ["roughness", "How wild a coast"],
  ["rivers", ""],
  ["attractors", "How fine"],
  ["winding", ""],
  ["width", "How wide"],
];

/** The keys that a padlock in front keeps besides its own: a land is nothing without its outline and its shape. */
const KEPT_WITH: ReadonlyMap<string, readonly string[]> = new Map([["land", ["outline", "aspect"]]]);

/**
 * Parameters that are under no heading: the land's control is in front, names have a list of their own, and a style is
 * chosen on the strip beside the panel.
 */
const ELSEWHERE: ReadonlySet<string> = new Set(["land", "names", "style"]);

/** Makes the controls. `speed` is a setting of the page and not of the recipe. */
export function controls(
  table: readonly Parameter[],
  changeMany: ChangeOfMany,
  disclosures: Disclosures,
  padlocks: Padlocks,
  speed: HTMLElement,
): Controls {
  const change = (key: string, text: string): void => changeMany([[key, text]]);
  const byKey = new Map(table.filter(isAdjustable).map((parameter) => [parameter.key, parameter]));
  const front = frontControls(byKey, changeMany, padlocks);
  const single = new Map(
    [...byKey].filter(([key]) => !ELSEWHERE.has(key)).map(([key, one]) => [key, control(one, change)]),
  );
  const groups = [...grouped([...byKey.values()].filter(({ key }) => single.has(key)))].map(([heading, parameters]) =>
    group(heading, parameters, single, disclosures),
  );
  const style = styleControl(byKey.get("style"), change);
  const settings = new Settings(groups, disclosures, [...style.map(({ element }) => element), speed]);
  const all: [string, Control][] = [
    ...front.single,
    ...single,
    ...style.map((one): [string, Control] => ["style", one]),
  ];
  return {
    front: front.element,
    settings: settings.element,
    show(map) {
      const { asked, defaults, idle } = map;
      for (const [key, one] of all) {
        const text = asked.get(key);
        if (text === undefined) continue;
        one.show(text, defaults.get(key) ?? "", idle.get(key), automaticValue(key, map));
      }
      for (const [key, one] of front.single) one.element.hidden = idle.has(key);
      for (const one of front.macros) one.show(map);
      for (const one of groups) one.show(asked, defaults);
      settings.show(new Set([...idle.keys()].filter((key) => single.has(key))));
    },
  };
}

/** Makes what stands in front, each with a padlock. */
function frontControls(
  byKey: ReadonlyMap<string, Parameter>,
  change: ChangeOfMany,
  padlocks: Padlocks,
): { element: HTMLElement; single: [key: string, control: Control][]; macros: MacroControl[] } {
  const element = el("div", { class: "front members" });
  const single: [string, Control][] = [];
  const macros: MacroControl[] = [];
  const put = (one: HTMLElement, label: string, keys: readonly string[]): void => {
    one.querySelector(".control-head label")?.after(padlocks.padlock(label, keys));
    element.append(one);
  };
  for (const [name, label] of FRONT) {
    const macro = MACROS.find((one) => one.name === name);
    const parameter = byKey.get(name);
    if (macro) {
      const made = macroControl(macro, byKey, change);
      macros.push(made);
      put(made.element, macro.label, keysOf(macro));
    } else if (parameter) {
      const made = frontControl(parameter, label, (key, text) => change([[key, text]]));
      single.push([name, made]);
      put(made.element, label, [name, ...(KEPT_WITH.get(name) ?? [])]);
    }
  }
  return { element, single, macros };
}

/** Makes the control of the style for windows that are too low for the strip. */
function styleControl(style: Parameter | undefined, change: (key: string, text: string) => void): Control[] {
  if (!style) return [];
  const made = control(style, change);
  made.element.classList.add("without-strip");
  return [made];
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
