/** The presets: named sets of values, from the core. */

import type { Parameter, Preset } from "../pkg/riverseed.js";
import { el } from "./dom.ts";
import { inWords } from "./values.ts";

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

/**
 * What pressing a preset changes besides what tells the presets from each other, in words: people press one for the latter,
 * and would miss the former. Nothing if that is all it changes.
 */
export function besides(
  preset: Preset,
  all: readonly Preset[],
  table: readonly Parameter[],
  before: ReadonlyMap<string, string>,
): string | undefined {
  const [first, ...others] = all.map((one) => new Map(presetValues(one, all, table)));
  const isCommon = (key: string) => others.every((values) => values.get(key) === first?.get(key));
  const after = new Map(presetValues(preset, all, table));
  const changes = table.flatMap((parameter) => {
    const [was, is] = [before.get(parameter.key), after.get(parameter.key)];
    if (was === undefined || is === undefined || was === is || !isCommon(parameter.key)) return [];
    return `${parameter.label} from ${inWords(parameter, was)} to ${inWords(parameter, is)}`;
  });
  return changes.length === 0 ? undefined : `“${preset.label}” also changed ${changes.join(", ")}.`;
}

export interface Presets {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>): void;
  /** Puts the focus on the preset that was pressed last. */
  focus(): void;
}

export function presets(
  all: readonly Preset[],
  table: readonly Parameter[],
  choose: (preset: Preset, values: Values) => void,
): Presets {
  let last: HTMLButtonElement | undefined;
  const made = all.map((preset) => {
    const values = presetValues(preset, all, table);
    const attributes = { type: "button", class: "preset", "aria-pressed": "false", title: preset.help };
    const button = el("button", attributes, preset.label);
    button.addEventListener("click", () => {
      last = button;
      choose(preset, values);
    });
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
    focus: () => last?.focus({ preventScroll: true }),
  };
}
