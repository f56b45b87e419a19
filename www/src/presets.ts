/** The presets: named sets of values, from the core. */

import type { Parameter, Preset } from "../pkg/riverseed.js";
import { el } from "./dom.ts";

export type Values = readonly (readonly [key: string, value: string])[];

/**
 * What pressing a preset sets. A preset leaves a key out to mean its default, so whatever any preset names goes back to
 * its default first; the seed, the land and all else that no preset speaks of stay as they are. All presets are ways of
 * the growth that is the default.
 */
export function presetValues(preset: Preset, all: readonly Preset[], table: readonly Parameter[]): Values {
  const own = new Map(preset.values);
  const named = new Set(["growth", ...all.flatMap(({ values }) => values.map(([key]) => key))]);
  return table
    .filter(({ key }) => named.has(key))
    .map((parameter) => [parameter.key, own.get(parameter.key) ?? parameter.default]);
}

/** Whether the values on show are this preset's. */
export function isShown(values: Values, shown: ReadonlyMap<string, string>): boolean {
  return values.every(([key, value]) => shown.get(key) === value);
}

export interface Presets {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>): void;
}

export function presets(
  all: readonly Preset[],
  table: readonly Parameter[],
  choose: (values: Values) => void,
): Presets {
  const made = all.map((preset) => {
    const values = presetValues(preset, all, table);
    const attributes = { type: "button", class: "preset", "aria-pressed": "false", title: preset.help };
    const button = el("button", attributes, preset.label);
    button.addEventListener("click", () => choose(values));
    return { preset, values, button };
  });
  const help = el("p", { class: "help" });
  const buttons = el("div", { class: "preset-buttons" }, ...made.map(({ button }) => button));
  const element = el("div", { class: "presets", role: "group", "aria-label": "Presets" }, buttons, help);
  return {
    element,
    show(shown) {
      const current = made.find(({ values }) => isShown(values, shown));
      for (const one of made) one.button.setAttribute("aria-pressed", String(one === current));
      help.textContent = current?.preset.help ?? "Ways of growing: choose one, then change what you like.";
    },
  };
}
