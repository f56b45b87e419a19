/** All controls of the recipe but the seed, generated from the parameter table, under the table's own headings. */

import type { Parameter } from "../pkg/riverseed.js";
import { type Control, control } from "./control.ts";
import { el } from "./dom.ts";
import type { Change } from "./field.ts";
import { idleReason } from "./idle.ts";
import { rangeOf } from "./values.ts";

export interface Controls {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>): void;
}

/** A parameter with one possible value (the edition) has nothing to set; the seed has a box of its own, an outline is drawn. */
export function isAdjustable(parameter: Parameter): boolean {
  const range = rangeOf(parameter);
  return parameter.key !== "seed" && parameter.kind !== "outline" && !(range && range.min === range.max);
}

export function controls(table: readonly Parameter[], change: Change): Controls {
  const made = new Map<string, Control>();
  const element = el("div", { class: "groups" });
  for (const [heading, parameters] of grouped(table.filter(isAdjustable))) {
    const members = parameters.map((parameter) => {
      const one = control(parameter, change);
      made.set(parameter.key, one);
      return one.element;
    });
    element.append(group(heading, members));
  }
  return {
    element,
    show(values) {
      for (const [key, one] of made) {
        const text = values.get(key);
        if (text !== undefined) one.show(text, idleReason(key, values));
      }
    },
  };
}

function group(heading: string, members: HTMLElement[]): HTMLElement {
  const summary = el("summary", {}, el("h2", {}, heading));
  return el("details", { class: "group", open: true }, summary, el("div", { class: "members" }, ...members));
}

function grouped(table: readonly Parameter[]): Map<string, Parameter[]> {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of table) {
    const members = groups.get(parameter.group);
    if (members) members.push(parameter);
    else groups.set(parameter.group, [parameter]);
  }
  return groups;
}
